//! The form of the vocabulary of signals and objects; `generated/classes.rs` fills it.

/// Makes the enumerations of classes and their groups.
macro_rules! classes {
    ($($(#[$gdoc:meta])* $group:ident { $($(#[$doc:meta])* $class:ident = $code:literal, $text:literal, $landmark:literal;)* })*) => {
        /// What a signal or object means (`docs/ontology.md`).
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u16)]
        #[non_exhaustive]
        pub enum Class {
            $($($(#[$doc])* $class = $code,)*)*
            /// A code that no table maps.
            Unknown = 65535,
        }

        /// Kind of classes.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum ClassGroup {
            $($(#[$gdoc])* $group,)*
            /// Not known.
            Unknown,
        }

        impl Class {
            /// All classes, in the order of their groups.
            pub const ALL: &[Self] = &[$($(Self::$class),*),*];

            /// The class of a code; codes that this version does not know give `Unknown`.
            pub const fn from_code(code: u16) -> Self {
                match code { $($($code => Self::$class,)*)* _ => Self::Unknown }
            }

            /// The code.
            pub const fn code(self) -> u16 {
                self as u16
            }

            /// The class of a name; names that this version does not know give `Unknown`.
            pub fn from_name(name: &str) -> Self {
                match name { $($($text => Self::$class,)*)* _ => Self::Unknown }
            }

            /// The name.
            pub const fn name(self) -> &'static str {
                match self { $($(Self::$class => $text,)*)* Self::Unknown => "unknown" }
            }

            /// Whether localisers find such a thing again: it is fixed, seen from the road and has a place of its own.
            pub const fn is_landmark(self) -> bool {
                match self { $($(Self::$class => $landmark,)*)* Self::Unknown => false }
            }

            /// The kind of class.
            pub const fn group(self) -> ClassGroup {
                match self { $($(Self::$class => ClassGroup::$group,)*)* Self::Unknown => ClassGroup::Unknown }
            }
        }

        #[cfg(feature = "serde")]
        impl serde::Serialize for Class {
            /// As its name.
            fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                to.serialize_str(self.name())
            }
        }

        #[cfg(feature = "serde")]
        impl<'de> serde::Deserialize<'de> for Class {
            /// From its name; one that this version does not know is an error.
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let name = String::deserialize(from)?;
                match Self::from_name(&name) {
                    Self::Unknown if name != Self::Unknown.name() => {
                        let what = stringify!(Class);
                        Err(serde::de::Error::custom(format_args!("expected a {what}, found {name:?}")))
                    }
                    known => Ok(known),
                }
            }
        }
    };
}
pub(crate) use classes;
