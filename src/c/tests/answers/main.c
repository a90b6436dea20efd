/* Answers the questions of a file in C and compares bit by bit. `answers ARCHIVE ANSWERS OVERLAY`. */
#include "c.h"

mapd_snapshot *map, *under;
mapd_scratch *scratch;
mapd_projector *projector;
mapd_error error;
uint64_t content;

void must(mapd_code code) {
  if (code == MAPD_CODE_OK) return;
  fprintf(stderr, "code %d: %s\n", (int)code, error.message);
  exit(EXIT_FAILURE);
}

int is(mapd_code code) {
  if (code != MAPD_CODE_NONE) must(code);
  return code == MAPD_CODE_OK;
}

void add_v(struct numbers *out, mapd_vec3 v) {
  add_f(out, v.x);
  add_f(out, v.y);
  add_f(out, v.z);
}

void add_nearest(struct numbers *out, mapd_lane_id lane, mapd_lane_position p) {
  add_u(out, lane_bits(lane));
  add_f(out, p.s);
  add_f(out, p.t);
  add_f(out, p.offset);
  add_f(out, p.offset_of_reference_line);
  add_f(out, p.distance);
  add_f(out, p.z);
  add_f(out, p.heading);
  add_f(out, p.heading_of_reference_line);
  add_u(out, p.clamped);
}

void add_pose(struct numbers *out, mapd_pose pose) {
  add_v(out, pose.position);
  add_f(out, pose.heading);
  add_f(out, pose.curvature);
  add_f(out, pose.slope);
  add_f(out, pose.superelevation);
  add_u(out, pose.clamped);
}

void add_signal(struct numbers *out, mapd_signal_id signal) {
  mapd_signal_facts facts;
  must(mapd_signal_facts_of(map, signal, &facts, &error));
  add_u(out, text_hash(facts.id));
}

void add_object(struct numbers *out, mapd_object_id object) {
  mapd_object_facts facts;
  must(mapd_object_facts_of(map, object, &facts, &error));
  add_u(out, text_hash(facts.id));
}

/* Opens the map under the overlay of a file. */
static void lay_over(const char *path) {
  static uint8_t bytes[MOST];
  FILE *file = fopen(path, "rb");
  if (!file) exit(EXIT_FAILURE);
  const size_t size = fread(bytes, 1, sizeof bytes, file);
  fclose(file);
  must(mapd_snapshot_with_overlay(map, bytes, size, &under, &error));
}

/* Whether a kind stands among words with blanks around each. */
static int one_of(const char *kind, const char *all) {
  char word[32];
  snprintf(word, sizeof word, " %s ", kind);
  return strstr(all, word) != NULL;
}

int main(int argc, char **argv) {
  if (argc != 4) return EXIT_FAILURE;
  must(mapd_snapshot_open(argv[1], &map, &error));
  mapd_map_facts facts;
  must(mapd_map_facts_of(map, &facts, &error));
  content = facts.content;
  must(mapd_scratch_new(&scratch, &error));
  lay_over(argv[3]);
  if (mapd_projector_new(map, &projector, &error) != MAPD_CODE_OK) projector = NULL;
  FILE *file = fopen(argv[2], "r");
  if (!file) return EXIT_FAILURE;
  char *line = NULL, *kind = NULL;
  size_t room = 0, asked = 0, wrong = 0;
  struct numbers question = {0}, answer = {0}, found = {0};
  while (read_line(file, &line, &room, &kind, &question, &answer)) {
    found.count = 0;
    if (one_of(kind, " road region details sign thing earth whole ")) {
      parts(kind, question.all, &found);
    } else if (one_of(kind, " nearest near objects landmarks around ")) {
      points(kind, question.all, &found);
    } else if (one_of(kind, " track inertial surface ")) {
      roads(kind, question.all, &found);
    } else if (one_of(kind, " route lines path along room ")) {
      routes(kind, question.all, &found);
    } else if (strcmp(kind, "reachable") == 0) {
      reachable(question.all, &found);
    } else if (strcmp(kind, "ground") == 0) {
      ground(question.all, &found);
    } else if (strcmp(kind, "mark") == 0) {
      mark(question.all, &found);
    } else if (strcmp(kind, "match") == 0) {
      match(question.all, &found);
    } else if (strcmp(kind, "trace") == 0) {
      trace(question.all, question.count, &found);
    } else if (strcmp(kind, "today") == 0) {
      today(question.all, &found);
    } else if (strcmp(kind, "request") == 0) {
      request(question.all, &found);
    } else if (strcmp(kind, "tracker") == 0) {
      tracker(question.all, question.count, &found);
    } else if (strcmp(kind, "stance") == 0) {
      stance(question.all, &found);
    } else if (strcmp(kind, "sees") == 0) {
      sees(question.all, &found);
    } else if (strcmp(kind, "paint") == 0) {
      paint(question.all, &found);
    } else if (strcmp(kind, "comes") == 0) {
      comes(question.all, &found);
    } else if (strcmp(kind, "geodetic") == 0) {
      geodetic(question.all, &found);
    } else if (one_of(kind, " pose position at edges lane movement line ahead sequences junction ")) {
      lanes(kind, question.all, &found);
    } else {
      fprintf(stderr, "no kind %s\n", kind);
      return EXIT_FAILURE;
    }
    ++asked;
    if (!same(&answer, &found) && wrong++ < 5) fprintf(stderr, "question %zu, %s: another answer\n", asked, kind);
  }
  fclose(file);
  free(line);
  free(question.all);
  free(answer.all);
  free(found.all);
  mapd_projector_close(&projector);
  mapd_scratch_close(&scratch);
  mapd_snapshot_close(&under);
  mapd_snapshot_close(&map);
  printf("%zu questions, %zu other answers\n", asked, wrong);
  return asked > 0 && wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
