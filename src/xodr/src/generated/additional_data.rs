//! Elements of `additional_data`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/additional_data.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Quality of the data around it (`t_dataQuality`; section 6; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DataQuality {
    /// The start tag.
    pub span: Span,
    /// `error`: Errors of the data.
    pub error: Option<Box<DataError>>,
    /// `rawData`: Origin of the data.
    pub raw_data: Option<Box<RawData>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Errors of the data (`t_dataQuality_Error`; section 6; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DataError {
    /// The start tag.
    pub span: Span,
    /// `@xyAbsolute` `[m]`: Absolute horizontal error. Required.
    pub xy_absolute: Option<Attribute<f64>>,
    /// `@zAbsolute` `[m]`: Absolute vertical error. Required.
    pub z_absolute: Option<Attribute<f64>>,
    /// `@xyRelative` `[m]`: Relative horizontal error. Required.
    pub xy_relative: Option<Attribute<f64>>,
    /// `@zRelative` `[m]`: Relative vertical error. Required.
    pub z_relative: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Origin of the data (`t_dataQuality_RawData`; section 6; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RawData {
    /// The start tag.
    pub span: Span,
    /// `@date`: Date of creation. Required.
    pub date: Option<Attribute<Box<str>>>,
    /// `@source`: Where the data come from. Required.
    pub source: Option<Attribute<RawDataSource>>,
    /// `@sourceComment`: Remark on the source.
    pub source_comment: Option<Attribute<Box<str>>>,
    /// `@postProcessing`: What was done to the data. Required.
    pub post_processing: Option<Attribute<PostProcessing>>,
    /// `@postProcessingComment`: Remark on the processing.
    pub post_processing_comment: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Another file whose content stands here (`t_include`; section 6).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Include {
    /// The start tag.
    pub span: Span,
    /// `@file`: Path of the file whose content is put in, relative to this one. Required since 1.5.
    pub file: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Data of an application (`t_userData`; section 6).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UserData {
    /// The start tag.
    pub span: Span,
    /// `@code`: Code that says whose data these are. Required since 1.5.
    pub code: Option<Attribute<Box<str>>>,
    /// `@value`: The data. Required in 1.5.
    pub value: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
