//! Numbers that are not finite, as data: JSON has none of them.

use serde::{Deserialize, Deserializer};

/// A column of numbers, of which those that are NaN were written as nothing.
pub(crate) fn list<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<f64>, D::Error> {
    let read = Vec::<Option<f64>>::deserialize(from)?;
    Ok(read.into_iter().map(|number| number.unwrap_or(f64::NAN)).collect())
}

/// A speed limit: the infinite one is written as `"unlimited"`, because JSON would take it for none.
pub(crate) mod limit {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    #[serde(untagged)]
    enum Written {
        Number(f64),
        Word(Word),
    }

    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    enum Word {
        Unlimited,
    }

    pub(crate) fn serialize<S: Serializer>(limit: &Option<f64>, to: S) -> Result<S::Ok, S::Error> {
        let written = |limit: &f64| match limit.is_finite() {
            true => Written::Number(*limit),
            false => Written::Word(Word::Unlimited),
        };
        limit.as_ref().map(written).serialize(to)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
        let read = Option::<Written>::deserialize(from)?;
        Ok(read.map(|written| match written {
            Written::Number(limit) => limit,
            Written::Word(Word::Unlimited) => f64::INFINITY,
        }))
    }
}
