//! Rules of the road by country.
// Written by `cargo run -p mapd-schemas` from schemas/ontology; change that folder instead.

use crate::road_rules::{FromSide, RoadRules};

/// By country.
pub(crate) const RULES: &[RoadRules] = &[
    RoadRules {
        country: "AT",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "StVO 1960 § 19 (1), (5)",
    },
    RoadRules {
        country: "AU",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "Australian Road Rules r. 72; r. 62 (1) for turns at lights",
    },
    RoadRules {
        country: "CH",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "SVG Art. 36 (2), (3)",
    },
    RoadRules {
        country: "CN",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "Implementation Regulations of the Road Traffic Safety Law Art. 52 (2), (3)",
    },
    RoadRules {
        country: "DE",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "StVO § 8 (1), § 9 (3)",
    },
    RoadRules {
        country: "FR",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "Code de la route R415-5; Vienna Convention on Road Traffic 1968 Art. 16 (2)",
    },
    RoadRules { country: "GB", from_side: None, turn: true, source: "Highway Code rule 180" },
    RoadRules {
        country: "JP",
        from_side: Some(FromSide::Left),
        turn: true,
        source: "Road Traffic Act Art. 36 (1), 37",
    },
    RoadRules {
        country: "NL",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "RVV 1990 art. 15 (1), 18 (1)",
    },
    RoadRules {
        country: "SE",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "Trafikförordning (1998:1276) 3 kap. 18 §, 24 §",
    },
    RoadRules {
        country: "US",
        from_side: Some(FromSide::Right),
        turn: true,
        source: "by state: California Vehicle Code § 21800, § 21801; New York VAT § 1140; Pennsylvania 75 § 3321",
    },
];
