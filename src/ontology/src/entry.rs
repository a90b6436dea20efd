//! An entry of a table, ready to be asked.

use crate::file::{Entry, EntryFault, File};
use crate::light::{Light, arrows};
use crate::pattern::Pattern;
use crate::value::{Source, Unit, sources, unit};
use mapd_archive::Class;
use std::collections::HashMap;

/// What a part of a code is asked for; parts are in lower case.
#[derive(Clone, Copy)]
pub(crate) struct Question<'a> {
    pub(crate) r#type: &'a str,
    pub(crate) subtype: &'a str,
    pub(crate) name: &'a str,
}

#[derive(Clone, Debug)]
pub(crate) struct Ready {
    r#type: Option<Pattern>,
    subtype: Option<Pattern>,
    name: Option<Pattern>,
    pub(crate) class: Class,
    pub(crate) sources: Vec<Source>,
    /// Of the entry.
    pub(crate) unit: Option<Unit>,
    /// Of the entry, else of the file.
    pub(crate) unit_here: Option<Unit>,
    /// Whether its file is for every country.
    pub(crate) is_everywhere: bool,
    pub(crate) light: Option<Light>,
}

impl Ready {
    pub(crate) fn new(
        entry: &Entry,
        file: &File,
        lights: &HashMap<String, Light>,
    ) -> Result<Self, EntryFault> {
        let class = Class::from_name(&entry.class);
        if class == Class::Unknown {
            return Err(EntryFault::Class(entry.class.clone()));
        }
        if entry.r#type.is_none() && entry.subtype.is_none() && entry.name.is_none() {
            return Err(EntryFault::Nothing);
        }
        let known = |name: &String| unit(name).ok_or_else(|| EntryFault::Unit(name.clone()));
        let own = entry.unit.as_ref().map(known).transpose()?;
        let of_file = file.unit.as_ref().map(known).transpose()?;
        let light = match &entry.light {
            Some(name) => {
                let light = lights.get(name).ok_or_else(|| EntryFault::Light(name.clone()))?;
                Some(Light { arrows: arrows(&entry.arrows)?, ..*light })
            }
            None => None,
        };
        Ok(Self {
            r#type: entry.r#type.as_deref().map(Pattern::new),
            subtype: entry.subtype.as_deref().map(Pattern::new),
            name: entry.name.as_deref().map(Pattern::new),
            class,
            sources: sources(entry, file)?,
            unit: own,
            unit_here: own.or(of_file),
            is_everywhere: file.countries.iter().any(|country| country == "*"),
            light,
        })
    }

    /// How much of what is asked the entry names; none if it does not fit. Type counts before subtype before name, an exact
    /// text before a pattern.
    pub(crate) fn fit(&self, question: Question<'_>) -> Option<u8> {
        let parts = [
            (&self.r#type, question.r#type, 16),
            (&self.subtype, question.subtype, 4),
            (&self.name, question.name, 1),
        ];
        let mut fit = 0;
        for (pattern, text, weight) in parts {
            if let Some(pattern) = pattern {
                if !pattern.fits(text) {
                    return None;
                }
                fit += weight * (1 + u8::from(pattern.is_exact()));
            }
        }
        Some(fit)
    }

    pub(crate) fn names_type_and_name(&self) -> bool {
        self.r#type.is_some() && self.name.is_some()
    }

    pub(crate) fn names_type(&self) -> bool {
        self.r#type.is_some()
    }
}
