//! Moments and times of the week, always UTC.

use jiff::SignedDuration;
use jiff::civil::DateTime;
use jiff::fmt::temporal::DateTimeParser;
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// 1970, from which moments are counted.
const EPOCH: DateTime = DateTime::constant(1970, 1, 1, 0, 0, 0, 0);

/// The years that text can say, -9999 to 9999, as seconds since the Unix epoch. The last moments of the year 9999 round to its end.
const YEARS: RangeInclusive<f64> = -377_705_116_800.0..=253_402_300_800.0;

/// A moment: RFC 3339 text, such as `2026-05-04T07:00:00Z`, or seconds since the Unix epoch.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Moment {
    /// Seconds since the Unix epoch, UTC; finite.
    pub unix_seconds: f64,
}

impl FromStr for Moment {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if let Ok(unix_seconds) = text.parse::<f64>() {
            return Self::of_seconds(unix_seconds).ok_or_else(expected);
        }
        let seconds = || {
            // Not a timestamp of the crate, which ends a day before the year 9999 does.
            let said = DateTimeParser::new().parse_pieces(text).ok()?;
            let (time, offset) = (said.time()?, said.to_numeric_offset()?);
            let local = said.date().to_datetime(time).duration_since(EPOCH);
            let utc = local.checked_sub(SignedDuration::from_secs(offset.seconds().into()))?;
            Self::of_seconds(utc.as_secs_f64())
        };
        seconds().ok_or_else(expected)
    }
}

fn expected() -> String {
    "expected a moment as 2026-05-04T07:00:00Z, or seconds since 1970".to_owned()
}

impl Moment {
    fn of_seconds(unix_seconds: f64) -> Option<Self> {
        YEARS.contains(&unix_seconds).then_some(Self { unix_seconds })
    }
}

impl fmt::Display for Moment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let since = SignedDuration::from_millis((self.unix_seconds * 1e3).round() as i64);
        match EPOCH.checked_add(since) {
            Ok(moment) => write!(f, "{moment}Z"),
            Err(_) => write!(f, "{}", self.unix_seconds),
        }
    }
}

impl Serialize for Moment {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Moment {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Either;
        impl Visitor<'_> for Either {
            type Value = Moment;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a moment as \"2026-05-04T07:00:00Z\", or seconds since 1970")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Moment, E> {
                text.parse().map_err(E::custom)
            }

            fn visit_f64<E: de::Error>(self, seconds: f64) -> Result<Moment, E> {
                Moment::of_seconds(seconds).ok_or_else(|| E::custom(expected()))
            }

            fn visit_u64<E: de::Error>(self, seconds: u64) -> Result<Moment, E> {
                self.visit_f64(seconds as f64)
            }

            fn visit_i64<E: de::Error>(self, seconds: i64) -> Result<Moment, E> {
                self.visit_f64(seconds as f64)
            }
        }
        from.deserialize_any(Either)
    }
}

/// A day of the week.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Day {
    /// Monday.
    Mon,
    /// Tuesday.
    Tue,
    /// Wednesday.
    Wed,
    /// Thursday.
    Thu,
    /// Friday.
    Fri,
    /// Saturday.
    Sat,
    /// Sunday.
    Sun,
}

/// A time of the day as `07:30`, up to `24:00`: seconds since midnight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct TimeOfDay(pub u32);

impl Serialize for TimeOfDay {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(&format_args!("{:02}:{:02}", self.0 / 3600, self.0 / 60 % 60))
    }
}

impl<'de> Deserialize<'de> for TimeOfDay {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let text = std::borrow::Cow::<'de, str>::deserialize(from)?;
        let two = |part: &str| match part.as_bytes() {
            [a, b] if a.is_ascii_digit() && b.is_ascii_digit() => part.parse::<u32>().ok(),
            _ => None,
        };
        let time = text.split_once(':').and_then(|(hours, minutes)| {
            let (hours, minutes) = (two(hours)?, two(minutes)?);
            let seconds = 3600 * hours + 60 * minutes;
            (minutes < 60 && seconds <= 24 * 3600).then_some(Self(seconds))
        });
        time.ok_or_else(|| de::Error::custom("expected a time of the day as 07:30, up to 24:00"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_read_and_written() {
        for (text, seconds) in [
            ("1970-01-01T00:00:00Z", 0.0),
            ("2026-05-04T07:00:00Z", 1_777_878_000.0),
            ("2026-05-04T09:00:00+02:00", 1_777_878_000.0),
            ("1777878000.5", 1_777_878_000.5),
            ("2026-05-04T07:00:00.25Z", 1_777_878_000.25),
            ("-1", -1.0),
            // As programs say "for ever".
            ("9999-12-31T23:59:59Z", 253_402_300_799.0),
            ("9999-12-31T23:59:59.999Z", 253_402_300_799.999),
            ("9999-12-31T23:59:59.9999999Z", 253_402_300_800.0),
            ("0000-01-01T00:00:00Z", -62_167_219_200.0),
            ("-009999-01-01T00:00:00Z", -377_705_116_800.0),
        ] {
            let moment: Moment = text.parse().expect(text);
            assert_eq!(moment.unix_seconds, seconds, "{text}");
            assert_eq!(moment.to_string().parse(), Ok(moment), "{text}");
        }
        for bad in [
            "",
            "yesterday",
            "NaN",
            "inf",
            "1e30",
            "2026-13-01T00:00:00Z",
            "2026-05-04",
            "2026-05-04T07:00:00",
            "9999-12-31T23:59:59-01:00",
            "253402300801",
        ] {
            assert!(bad.parse::<Moment>().is_err(), "{bad}");
        }
        let written = |seconds| Moment { unix_seconds: seconds }.to_string();
        assert_eq!(written(1_777_878_000.0), "2026-05-04T07:00:00Z");
        assert_eq!(written(1_777_878_000.5), "2026-05-04T07:00:00.5Z");
        assert_eq!(written(253_402_300_799.0), "9999-12-31T23:59:59Z");
    }

    #[test]
    fn times_of_the_day() {
        let read = |text: &str| serde_json::from_value::<TimeOfDay>(text.into());
        assert_eq!(read("07:30").expect("a time"), TimeOfDay(27_000));
        assert_eq!(read("24:00").expect("a time"), TimeOfDay(86_400));
        for bad in ["24:01", "7:30", "07:60", "0730", "+7:30", ""] {
            assert!(read(bad).is_err(), "{bad}");
        }
    }
}
