//! What a compiled map answers: lanes, positions, graph, routes, signals, objects, heights.

// Alternatives: the k best routes are those of Yen's algorithm of another library.
mod alternatives;
// What files say of their parts beyond what anything is built from: each arrives with its owner, its place and its text.
mod annotations;
// Results and options as JSON, with the feature `serde`.
mod as_json;
// Batches answer as single calls do, bit for bit and in the caller's order, and name what is wrong by its number.
mod batches;
// Rows that begin at or before a place are counted as a binary search counts them.
mod begun;
// Points to lanes and to track coordinates against looking everywhere.
mod brute_force;
// Conflicts against looking at points: where two lanes of a junction both cover a point, they conflict there.
mod conflicts;
// Every value of the schema arrives: written in two ways, it makes two archives.
mod coverage;
// A crossing of four arms.
mod crossroads;
// Left, right and ahead are those of a lane's traffic.
mod driving_direction;
// Latitudes and longitudes: against figures of PROJ, there and back, and on maps.
mod geodesy;
// Lane graphs of small maps made by hand: edges, what is wrong with links, cycles, lane changes, conflicts.
mod graph_maps;
// The ground below a place: that of the road's surface, on the level that z says.
mod ground;
// Ids as plain integers.
mod ids;
// The packed index against rstar, and the nearest lane against looking at every lane.
mod index_oracle;
// Every type that can be read from JSON is read as it was written.
mod json_round_trips;
// Lanes of simulated drives beside the best that is possible.
mod judged;
// Landmarks for localisation, and signals near a point and in a rectangle.
mod landmarks;
// The lane graph against a slow, literal reader of the links.
mod lane_graph;
// Headings and curvatures of lanes, by differences of positions.
mod lane_headings;
// Lanes of the temporary layer.
mod lane_layers;
mod lengths;
// Lengths along lanes of very many records, with and without those that are stored.
mod stored_lengths;
// Which lanes a pose may be in.
mod matching;
// The nearest road mark: worked out by hand on marks of every form, and against places all along all marks.
mod nearest_marks;
mod nearest_passing;
mod nearest_ties;
// Every object of the shared corpus is in its map, or named as left out.
mod object_counts;
// What is written in and beside objects: markings, borders, skeletons, parking, repetitions, references, bridges, tunnels, railways.
mod object_details;
// Which lanes objects belong to: by what the file names, by place, as the nearest.
mod object_lanes;
// Where objects of the shared corpus stand, worked out by hand from what their files say, across vendors and versions.
mod object_positions;
// Objects near a point and in a rectangle: against asking every place, on real maps and on many copies.
mod object_queries;
// Shapes of objects: each kind once, with corners worked out by hand.
mod object_shapes;
// The vocabulary of signals and objects: codes of many catalogues, the corpus, and a country that is only a file.
mod ontology;
// The share of a vehicle that lies in a lane.
mod outlines;
// Overlays: what is refused, when entries hold, what a view says.
mod overlays;
// Overlays: a line along lanes that links join means all of them, however short they are and whatever lies over them.
mod overlays_lines;
// A view over a plain map answers as a map with the same written into its OpenDRIVE.
mod overlays_oracle;
// What a view says along routes and paths: entries that are met, today's limits and times, where a change of lane is due.
mod overlays_paths;
// Overlays: places by latitude and longitude, and feeds of road authorities.
mod overlays_places;
// Whether a view and a map with the same written into it find the same ways, and say the same along one path.
mod overlays_same_ways;
// The schema of entries that is published says what the reader reads.
mod overlays_schema;
// Bounds of a search on pieces of a lane: a change of lane in its middle may save more than the lane takes.
mod overlays_bounds;
// Places that are too short to be cut out of a lane: each holds somewhere or is told, never neither.
mod overlays_short;
// A start on a closed lane: it is left, not entered.
mod overlays_start;
// Feeds of work zones: every word that the specification of WZDx 4.2 lists becomes an entry or a finding.
mod overlays_wzdx;
// Points along what is painted as an object: worked out by hand, and the same ones by whatever rectangle.
mod painted_objects;
// What lies along a path: lanes that reach the goal, speed limits, signals, lines, junctions.
mod path_ahead;
// Changes of lane as a curve over a length.
mod path_changes;
// Nothing along a path is left out and nothing is told that is not there: what another way of asking collects, lane by lane and place by place.
mod path_complete;
// Feet on a path without a hint: the nearest place of all.
mod path_feet;
// What the line of a path is: how far its parts lie apart, how it bends and rolls, and which of two rounds is meant.
mod path_joints;
// Who meets a path: lanes that merge into it, lanes of other roads at the same place, crosswalks, and the lanes that lead there.
mod path_meets;
// Every lane that meets a path is told: those that another way of asking finds.
mod path_met_all;
// What of the lanes that meet a path is its own way.
mod path_own_way;
// A path on another version of its map.
mod path_rebase;
// The room along a path: marks, what lies beyond, speed, surface, outline.
mod path_room;
// Paths over lists of lanes that somebody has made, how long they take, and the facts of roads along them.
mod path_steps;
// Routes as lines: S, joints, projection, edges, conflicts.
mod paths;
// Results that are plain data have the layout of C.
mod plain_data;
// Polylines never lie farther from the exact lines than the options say: dense comparison, several tolerances.
mod polylines;
// Requests with several starts and goals, lanes to avoid, headings.
mod reach;
// Positions and lanes against an independent evaluator, over every map of the shared corpus.
mod reference;
// Lanes and borders near a point or in a rectangle, against looking at every lane.
mod regions;
// Who goes first: what is written, else what the country says that the caller names; nothing is taken from geometry alone.
mod right_of_way;
// Roads above, beside and around each other: the right one wins.
mod right_road;
// Road marks: what the file says of them is what the map answers.
mod road_marks;
// Points to track coordinates and back: on random roads of every kind of curve, degenerate ones among them, and on real maps.
mod round_trips;
// Routes cost what plain Dijkstra finds, and drive only where it is allowed.
mod routing;
// Boards of signals, and what signals, boards and objects have to do with each other.
mod signal_boards;
// Positions and facing of signals across vendors and versions, each worked out by hand from what the file says.
mod signal_positions;
// Which roads' lanes a signal is for where other roads refer to it: a validity limits lanes, also to none.
mod signal_references;
// Signals of every map of the corpus: as many as the manifest says, each placed and either for lanes or named in a finding.
mod signals_corpus;
// Sections that replace the lanes of one side only, borders instead of widths, widths that reach zero.
mod single_side;
// Which speed limit holds, and who says so.
mod speed_rules;
// The road's surface: heights and normals worked out by hand, and normals against differences.
mod surfaces;
// Traces: the lanes of drives that were simulated with noise, where a trace leaves the map, and what is refused.
mod traces;
// The running filter.
mod tracking;
// Who may drive where, which way a lane leads, and what yields rest on.
mod who_may;
