//! The archive's bytes, in place and read-only.
#![allow(unsafe_code)]

use crate::errors::client;
use crate::map::Map;
use mapd_client::ClientError;
use mapd_client::raw::directory;
use numpy::ndarray::ArrayView1;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

/// The archive's bytes as an array that cannot be written to, and whose owner is the map.
pub(crate) fn bytes<'py>(map: &Bound<'py, Map>) -> Bound<'py, PyArray1<u8>> {
    let view = ArrayView1::from(map.get().held().snapshot().bytes());
    // SAFETY: the bytes belong to the map's snapshot, which neither moves nor frees them while it lives. The map is frozen, keeps the
    // snapshot, and is the array's owner, so that it lives as long as any view does. Nobody else writes to the bytes, and nobody
    // does through the array: it is made read-only here, before anybody has it, and numpy makes an array writable again only
    // where its owner is a writable buffer, which a map is not.
    let array = unsafe { PyArray1::borrow_from_array(&view, map.clone().into_any()) };
    array.readwrite().make_nonwriteable();
    array
}

/// Number, bytes of a row, row id, first byte and number of rows of a table.
pub(crate) type Entry = (u32, u32, u64, u64, u64);

/// What the directory says of each table.
pub(crate) fn tables(map: &Map) -> PyResult<Vec<Entry>> {
    let entries = directory(map.held().snapshot().bytes()).map_err(|source| {
        client(ClientError::Open { source_name: "archive".to_owned(), source })
    })?;
    Ok(entries.iter().map(|e| (e.number, e.row_bytes, e.row_id, e.offset, e.count)).collect())
}
