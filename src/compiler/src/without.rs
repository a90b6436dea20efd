//! What may be left out of an archive.

use mapd_archive::AnnotationKind;

macro_rules! extras {
    ($($(#[$doc:meta])* $name:ident = $bit:literal, $text:literal;)*) => {
        /// What an archive can do without: nothing else in it depends on these.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum Extra {
            $($(#[$doc])* $name = $bit,)*
        }

        impl Extra {
            /// All that there are.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Name on the command line.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$name => $text,)* }
            }
        }
    };
}

extras! {
    /// `userData` of any element.
    UserData = 0, "user-data";
    /// `dataQuality` of any element.
    DataQuality = 1, "data-quality";
    /// Includes, and which parts came from which file.
    Includes = 2, "includes";
    /// Elements that the standard does not have, and those of other namespaces.
    Elements = 3, "elements";
    /// Attributes that nothing is built from.
    Attributes = 4, "attributes";
    /// How far one sees from lanes.
    Visibility = 5, "visibility";
    /// Rules of lanes in words.
    LaneRules = 6, "lane-rules";
    /// Junction groups and rings of roundabouts.
    JunctionGroups = 7, "junction-groups";
}

/// A set of what is left out; empty by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Without(u16);

impl Without {
    /// With one more left out.
    pub fn and(self, extra: Extra) -> Self {
        Self(self.0 | 1 << extra as u16)
    }

    /// Whether it is left out.
    pub fn has(self, extra: Extra) -> bool {
        self.0 >> extra as u16 & 1 == 1
    }

    /// Whether nothing is left out.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// As bytes that name the set.
    pub(crate) fn bytes(self) -> [u8; 2] {
        self.0.to_le_bytes()
    }

    /// Whether annotations of a kind are left out.
    pub(crate) fn leaves_out(self, kind: AnnotationKind) -> bool {
        let extra = match kind {
            AnnotationKind::UserData => Extra::UserData,
            AnnotationKind::DataQuality => Extra::DataQuality,
            AnnotationKind::Include | AnnotationKind::SourceFile => Extra::Includes,
            AnnotationKind::UnknownElement | AnnotationKind::ForeignElement => Extra::Elements,
            _ => Extra::Attributes,
        };
        self.has(extra)
    }
}

impl FromIterator<Extra> for Without {
    fn from_iter<I: IntoIterator<Item = Extra>>(all: I) -> Self {
        all.into_iter().fold(Self::default(), Self::and)
    }
}
