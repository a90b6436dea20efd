//! Top-level elements, checked and lowered: one by one, or a batch of them by itself on any thread.

use crate::draft::Draft;
use crate::lower::{ObjectContext, Owner};
use crate::options::Lowering;
use crate::quarantine::Units;
use mapd_archive::AnnotationOwner;
use mapd_ontology::Ontology;
use mapd_rules::line::ReferenceLine;
use mapd_rules::{Checker, Examined, ExaminedItem, Examiner, Network, Whole};
use mapd_xodr::source::{NearPlaces, Places};
use mapd_xodr::{Batch, Context, Finding, Item, ReadBatch, Span, Text as _};
use rayon::prelude::*;
use std::collections::VecDeque;
use std::sync::Arc;

/// What the lowering of a batch needs to know.
pub(crate) struct Plan {
    examiner: Examiner,
    ontology: Arc<Ontology>,
    places: Places,
    lowering: Lowering,
}

/// What was found in an element.
#[derive(Default)]
pub(crate) struct Element {
    /// By the rules on elements.
    pub(crate) examined: Examined,
    /// By what built rows from it.
    pub(crate) built: Vec<Finding>,
    /// Roads in the rows of the part up to it.
    pub(crate) roads: usize,
}

/// What a batch was lowered to.
pub(crate) struct Lowered {
    pub(crate) elements: VecDeque<Element>,
    pub(crate) network: Network,
    pub(crate) units: Units,
    pub(crate) draft: Draft,
}

impl Plan {
    /// For batches of a document of which the header was seen.
    pub(crate) fn new(
        checker: &Checker,
        ontology: &Arc<Ontology>,
        places: &Places,
        lowering: Lowering,
    ) -> Self {
        let (ontology, places) = (Arc::clone(ontology), places.clone());
        Self { examiner: checker.examiner(), ontology, places, lowering }
    }

    /// Reads a batch; each of its elements is checked and lowered while it is still at hand.
    pub(crate) fn read(self, context: &Context, batch: Batch) -> (ReadBatch, Lowered) {
        let Self { mut examiner, ontology, places, lowering } = self;
        let mut draft = Draft::part(ontology, lowering);
        let places = batch.places(&places);
        let mut units = Units::default();
        let none = draft.roads();
        let mut elements = VecDeque::new();
        let read = context.read_each(batch, &mut |mut item| {
            units.add(&item);
            let ExaminedItem { found: examined, line } = examiner.item(&mut item);
            let mut built = Vec::new();
            lower(&mut draft, item, &line, &places, &mut built);
            elements.push_back(Element { examined, built, roads: draft.roads() - none });
            None
        });
        (read, Lowered { elements, network: examiner.into_network(), units, draft })
    }
}

/// What all rules on the document as a whole find, in their order.
pub(crate) fn examine(whole: &Whole) -> Vec<Examined> {
    let needs_overlaps = |check: usize| whole.needs_overlaps(check);
    let first_overlaps = (0..whole.checks()).find(|check| needs_overlaps(*check));
    let (first, mut all) = rayon::join(
        || first_overlaps.map(|check| whole.examine(check)),
        || {
            // Each is a task of its own: some take a hundred times as long as others. The longest come last in their order: begun
            // first, they keep no thread waiting at the end.
            let others = (0..whole.checks()).into_par_iter().rev().with_max_len(1);
            let look = |check| (!needs_overlaps(check)).then(|| whole.examine(check));
            let mut found: Vec<_> = others.map(look).collect();
            found.reverse();
            found
        },
    );
    if let Some(place) = first_overlaps.and_then(|check| all.get_mut(check)) {
        *place = first;
    }
    let all = all.into_iter().enumerate();
    all.map(|(check, examined)| examined.unwrap_or_else(|| whole.examine(check))).collect()
}

/// Appends what a top-level element says to the rows; its reference line is the one that the rules examined.
pub(crate) fn lower(
    draft: &mut Draft,
    item: Item,
    line: &ReferenceLine,
    places: &NearPlaces,
    findings: &mut Vec<Finding>,
) {
    let ontology = Arc::clone(&draft.signals.ontology);
    let position = |span: Span| places.position(span.start);
    draft.owners.clear();
    match item {
        Item::Header(header) => {
            draft.header(&header, findings);
            let document = (AnnotationOwner::Document, 0);
            draft.annotate(&*header, document, "header", places);
        }
        Item::Road(road) => {
            let number = draft.roads();
            draft.road(&road, line, position(road.span), findings);
            if draft.roads() == number {
                return;
            }
            if let Some(railroad) = road.railroad.as_deref() {
                draft.switches(number as u32, railroad);
            }
            if let Some(objects) = road.objects.as_deref() {
                let owner = Owner::Road(number as u32, road.id.text());
                let context = ObjectContext { ontology: &ontology, position };
                draft.objects(owner, objects, context, findings);
            }
            let owner = (AnnotationOwner::Road, number as u32);
            draft.annotate(&*road, owner, "", places);
        }
        Item::Station(station) => {
            let owner = (AnnotationOwner::Station, draft.objects.stations.len() as u32);
            draft.station(&station);
            draft.annotate(&*station, owner, "", places);
        }
        Item::Junction(junction) => {
            let number = draft.rows.junctions.len() as u32;
            let context = ObjectContext { ontology: &ontology, position };
            draft.junction_objects(&junction, number, context, line, findings);
            if junction.id.is_some() {
                let owner = (AnnotationOwner::Junction, number);
                draft.note_connections(&junction);
                draft.annotate(&*junction, owner, "", places);
            }
            let at = position(junction.span);
            draft.junction(&junction, line, at, findings);
        }
        Item::Controller(controller) => {
            let owner = (AnnotationOwner::Controller, draft.signals.controllers() as u32);
            draft.controller(&controller);
            draft.annotate(&*controller, owner, "", places);
        }
        Item::VmsGroup(group) => {
            draft.board_group(&group);
            let path = format!("vmsGroup[@id={}]", group.id.text());
            let document = (AnnotationOwner::Document, 0);
            draft.annotate(&*group, document, &path, places);
        }
        Item::JunctionGroup(group) => draft.junction_group(&group, places),
    }
}
