//! What the page answers is what the native build answers.

use crate::{browser, under_works};
use mapd_client::Map;
use mapd_tests::maps::{Random, carried_and, open};
use mapd_web::{Kind, Link, Question};
use serde_json::{Value, json};
use std::time::UNIX_EPOCH;

/// Questions of each map at least.
const QUESTIONS: usize = 2000;
/// Places that are asked about in each map, once for each kind of question about places.
const PLACES: usize = 800;
/// Of these, pairs between which a way is looked for.
const WAYS: usize = 60;
/// Things of each kind whose sheets are compared.
const SHEETS: u32 = 60;

fn questions(map: Map<'_>) -> Vec<Question<'static>> {
    let mut random = Random(11);
    let mut questions = vec![Question::LeftOut, Question::Find("1"), Question::Find("Straße <b>")];
    for i in 0..PLACES {
        let (from, to) = (random.point(map).to_array(), random.point(map).to_array());
        questions.extend([Question::Place(from), Question::Pick(from, 2.0)]);
        let projector = map.projector().ok();
        let place = projector.and_then(|one| one.to_geodetic([from[0], from[1], 0.0].into()).ok());
        questions.extend(place.map(|place| Question::Geodetic([place.latitude, place.longitude])));
        if i < WAYS {
            questions.push(Question::Way(from, to));
        }
    }
    for row in 0..SHEETS {
        questions.extend(
            Kind::ALL.iter().map(|kind| Question::Sheet(Link { kind: *kind, row: 7 * row })),
        );
    }
    questions
}

/// The question as the page asks it: the module's function and its numbers.
fn asked(question: &Question<'_>) -> Value {
    match question {
        Question::Place([x, y]) => json!(["place", x, y]),
        Question::Geodetic([latitude, longitude]) => json!(["geodetic", latitude, longitude]),
        Question::Pick([x, y], radius) => json!(["pick", x, y, radius]),
        Question::Way([a, b], [c, d]) => json!(["way", a, b, c, d]),
        Question::Sheet(link) => json!(["sheet", link.kind as usize, link.row]),
        Question::Find(text) => json!(["find", text]),
        Question::LeftOut => json!(["left_out"]),
        Question::Map => json!([]),
    }
}

/// Maps whose frame proj4rs alone computes, which a page does not have: it names no latitudes and longitudes there.
const ONLY_BY_PROJ4RS: [&str; 1] = ["soderleden.xodr"];

/// An answer without latitudes and longitudes.
fn without_geodetic(answer: &str) -> String {
    const NAME: &str = r#""geodetic":["#;
    let Some((before, rest)) = answer.split_once(NAME) else { return answer.to_owned() };
    let (_, after) = rest.split_once(']').expect("a list");
    format!(r#"{before}"geodetic":null{after}"#)
}

/// Asks all at once.
const ASK: &str = "(questions => questions.map(([name, ...of]) => {
    const { queries } = viewer;
    queries.module[name](...of.map(one => typeof one === 'string' ? queries.put(new TextEncoder().encode(one)) : one));
    return queries.text();
}))";

/// The same answers as the native build, to the last bit: numbers are written so that they are read back exactly.
#[test]
fn the_page_answers_as_the_native_build() {
    for path in carried_and(&["carla/Town05", "esmini/soderleden"]) {
        let snapshot = under_works(open(&path));
        let Some(mut browser) = browser(&snapshot) else { return };
        let mut questions = questions(snapshot.map());
        let is_excepted = ONLY_BY_PROJ4RS.iter().any(|name| path.ends_with(name));
        questions.retain(|question| !is_excepted || !matches!(question, Question::Geodetic(_)));
        assert!(questions.len() >= QUESTIONS, "only {}", questions.len());
        let list = Value::from(questions.iter().map(asked).collect::<Vec<_>>());
        let answers = browser.evaluate(&format!("{ASK}({list})"));
        let answers = answers.as_array().expect("answers");
        assert_eq!(answers.len(), questions.len());
        for (question, answer) in questions.iter().zip(answers) {
            let mut expected = question.answer(snapshot.view(UNIX_EPOCH)).json;
            if is_excepted {
                expected = without_geodetic(&expected);
            }
            assert_eq!(
                answer.as_str(),
                Some(expected.as_str()),
                "{question:?} of {}",
                path.display()
            );
        }
        assert_eq!(browser.complaints, [""; 0], "{}", path.display());
    }
}
