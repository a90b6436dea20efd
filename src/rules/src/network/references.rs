//! What names an id, and where it does.

use super::facts::PartKind;
use super::{Name, Network};
use mapd_xodr::Span;

/// Kinds of what a reference may mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Kinds {
    /// A road.
    Road,
    /// A junction.
    Junction,
    /// A controller.
    Controller,
    /// An object.
    Object,
    /// A signal.
    Signal,
    /// A signal, or a sign on a board.
    Signals,
    /// A signal, a sign or an object.
    SignalsAndObjects,
    /// A switch.
    Switch,
}

impl Kinds {
    /// The kinds, in the order in which messages name them.
    pub fn all(self) -> &'static [PartKind] {
        match self {
            Self::Road => &[PartKind::Road],
            Self::Junction => &[PartKind::Junction],
            Self::Controller => &[PartKind::Controller],
            Self::Object => &[PartKind::Object],
            Self::Signal => &[PartKind::Signal],
            Self::Signals => &[PartKind::Signal, PartKind::Sign],
            Self::SignalsAndObjects => &[PartKind::Signal, PartKind::Sign, PartKind::Object],
            Self::Switch => &[PartKind::Switch],
        }
    }
}

/// Lists where ids are named: the element with an id of its own, and the path from there.
macro_rules! places {
    ($($name:ident: $element:literal $path:literal,)*) => {
        /// Where an id is named: an element that has an id itself, and the path from there.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        pub enum NamedAt {
            $(#[doc = concat!("`", $element, "`: `", $path, "`")] $name,)*
        }

        impl NamedAt {
            /// Name of the element with an id of its own.
            pub fn element(self) -> &'static str {
                match self { $(Self::$name => $element,)* }
            }

            /// Element and attribute, as a path from there names them.
            pub fn path(self) -> &'static str {
                match self { $(Self::$name => $path,)* }
            }
        }
    };
}

places! {
    Control: "controller" "control/@signalId",
    GroupJunction: "junctionGroup" "junctionReference/@junction",
    PlatformSegment: "station" "segment/@roadId",
    Board: "vmsGroup" "vmsBoardReference/@signalId",
    MainRoad: "junction" "@mainRoad",
    IncomingRoad: "junction" "connection/@incomingRoad",
    ConnectingRoad: "junction" "connection/@connectingRoad",
    LinkedRoad: "junction" "connection/@linkedRoad",
    PriorityHigh: "junction" "priority/@high",
    PriorityLow: "junction" "priority/@low",
    JunctionController: "junction" "controller/@id",
    RoadSection: "junction" "roadSection/@roadId",
    CrossingRoad: "junction" "crossPath/@crossingRoad",
    PathStart: "junction" "crossPath/@roadAtStart",
    PathEnd: "junction" "crossPath/@roadAtEnd",
    BoundarySegment: "junction" "boundary/segment/@roadId",
    JunctionObject: "junction" "objects/objectReference/@id",
    RoadObject: "road" "objects/objectReference/@id",
    Neighbor: "road" "link/neighbor/@elementId",
    RoadJunction: "road" "@junction",
    Predecessor: "road" "link/predecessor/@elementId",
    Successor: "road" "link/successor/@elementId",
    SignalReference: "road" "signals/signalReference/@id",
    MainTrack: "switch" "switch/mainTrack/@id",
    SideTrack: "switch" "switch/sideTrack/@id",
    Partner: "switch" "switch/partner/@id",
    PositionRoad: "signal" "signal/positionRoad/@roadId",
    SignalDependency: "signal" "signal/dependency/@id",
    SignalLink: "signal" "signal/reference/@elementId",
    StaticDependency: "signal" "signal/staticBoard/dependency/@id",
    StaticLink: "signal" "signal/staticBoard/reference/@elementId",
    SignDependency: "signal" "signal/staticBoard/sign/dependency/@id",
    SignLink: "signal" "signal/staticBoard/sign/reference/@elementId",
    VmsDependency: "signal" "signal/vmsBoard/dependency/@id",
    VmsLink: "signal" "signal/vmsBoard/reference/@elementId",
}

/// Where an id is named, and kinds of what may be meant.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReferencePlace {
    at: NamedAt,
    kinds: Kinds,
}

impl NamedAt {
    /// With kinds of what may be meant there.
    pub(super) fn of(self, kinds: Kinds) -> ReferencePlace {
        ReferencePlace { at: self, kinds }
    }
}

/// Something that names an id.
#[derive(Clone, Copy, Debug)]
pub struct Reference {
    /// The start tag.
    pub span: Span,
    /// The id that is named.
    pub id: Name,
    /// Id of the element that [`NamedAt`] is a path from.
    pub from: Name,
    /// Where it stands.
    pub at: NamedAt,
    /// Kinds of what may be meant.
    pub kinds: Kinds,
}

impl Reference {
    /// One in an element with this start tag.
    pub(super) fn new(
        ReferencePlace { at, kinds }: ReferencePlace,
        id: Name,
        from: Name,
        span: Span,
    ) -> Self {
        Self { span, id, from, at, kinds }
    }

    /// Where it stands: elements from the root, with the id of the one that has one.
    pub fn path(&self, network: &Network) -> String {
        let (element, path) = (self.at.element(), self.at.path());
        // What stands along a road, by its kind alone.
        let above = match element {
            "signal" => "road/signals/",
            "switch" => "road/railroad/",
            _ => "",
        };
        let within = path.strip_prefix(element).and_then(|rest| rest.strip_prefix('/'));
        let from = network.name(self.from);
        format!("OpenDRIVE/{above}{element}[@id={from}]/{}", within.unwrap_or(path))
    }

    /// Moves what it names to the ids' numbers in the whole.
    pub(super) fn renamed(mut self, names: &[Name]) -> Self {
        for name in [&mut self.id, &mut self.from] {
            *name = renamed(*name, names);
        }
        self
    }
}

/// The number of an id in the whole.
pub(super) fn renamed(name: Name, names: &[Name]) -> Name {
    names.get(name.number()).copied().unwrap_or_default()
}
