//! Copies: what does not change is its own copy.

use crate::junction::Junction;
use crate::lane::Lane;
use crate::map::Map;
use crate::object::Object;
use crate::path::Path;
use crate::road::Road;
use crate::signal::Signal;
use crate::view::View;
use pyo3::prelude::*;

macro_rules! its_own_copy {
    ($($class:ident),*) => {$(
        #[pymethods]
        impl $class {
            fn __copy__(this: Py<Self>) -> Py<Self> {
                this
            }

            fn __deepcopy__(this: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
                this
            }
        }
    )*};
}

its_own_copy!(Map, Lane, Road, Junction, Signal, Object, Path, View);
