/* Clients of a daemon in C: what is opened is given back, and what is held outlives swaps, forks and the daemon. Ends with the daemon killed.
 *
 * `service MAP DAEMON_PID SWAP`: SWAP is a command that has the daemon serve another content under the same name. */
#define _GNU_SOURCE
#include <dirent.h>
#include <malloc.h>
#include <mapd.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { ATTACHES = 10000, THREADS = 8, QUERIES = 500, WARM = 100 };
/* How long anything that must happen may take [s]. */
static const double PATIENCE = 60.0;
/* What the allocator may keep for itself [bytes]. */
static const size_t SLACK = 16384;
static const mapd_point POINT = {50.0, -1.75, 0.0, 0};
static const char *name;
static mapd_error error;
static int failures = 0;

#define CHECK(condition)                                                                         \
  do {                                                                                           \
    if (!(condition)) {                                                                          \
      fprintf(stderr, "%s:%d: %s; last error: %s\n", __FILE__, __LINE__, #condition, error.message); \
      ++failures;                                                                                \
    }                                                                                            \
  } while (0)

static size_t entries(const char *folder) {
  size_t count = 0;
  DIR *opened = opendir(folder);
  if (!opened) return 0;
  while (readdir(opened)) ++count;
  closedir(opened);
  return count;
}

/* Mappings of the domain's shared memory. */
static size_t mappings(void) {
  const char *prefix = getenv("MAPD_PREFIX");
  char line[4096];
  size_t count = 0;
  FILE *file = fopen("/proc/self/maps", "r");
  if (!file || !prefix) return 0;
  while (fgets(line, sizeof line, file)) count += strstr(line, prefix) != NULL;
  fclose(file);
  return count;
}

static int answers(const mapd_snapshot *map) {
  mapd_nearest hit;
  return mapd_nearest_lane(map, POINT, NULL, &hit, NULL) == MAPD_CODE_OK && hit.position.distance == 0.0;
}

static void attach(void) {
  mapd_client *client = NULL;
  mapd_snapshot *map = NULL;
  mapd_events *events = NULL;
  CHECK(mapd_client_connect(name, NULL, PATIENCE, &client, &error) == MAPD_CODE_OK);
  CHECK(mapd_client_snapshot(client, &map, &error) == MAPD_CODE_OK);
  CHECK(mapd_events_new(client, &events, &error) == MAPD_CODE_OK);
  CHECK(answers(map));
  mapd_events_close(&events);
  mapd_client_close(&client);
  mapd_snapshot_close(&map);
}

static void nothing_is_left(void) {
  for (int i = 0; i < WARM; ++i) attach();
  const size_t files = entries("/proc/self/fd"), heap = mallinfo2().uordblks;
  CHECK(mappings() == 0);
  for (int i = 0; i < ATTACHES && failures == 0; ++i) attach();
  CHECK(mappings() == 0);
  CHECK(entries("/proc/self/fd") == files);
  CHECK(mallinfo2().uordblks <= heap + SLACK);
}

/* An observer takes no place of the map's, but needs a file descriptor at a time: without any the code says so, and nothing of the attempt is left. */
static void too_few_descriptors_are_an_error(void) {
  struct rlimit usual;
  mapd_client *client = NULL;
  const size_t files = entries("/proc/self/fd");
  CHECK(getrlimit(RLIMIT_NOFILE, &usual) == 0);
  const struct rlimit none = {0, usual.rlim_max};
  CHECK(setrlimit(RLIMIT_NOFILE, &none) == 0);
  const mapd_code code = mapd_client_connect(name, NULL, 0.2, &client, &error);
  CHECK(setrlimit(RLIMIT_NOFILE, &usual) == 0);
  CHECK(code == MAPD_CODE_NO_DESCRIPTORS && client == NULL);
  CHECK(strstr(error.message, "file descriptors") != NULL);
  CHECK(entries("/proc/self/fd") == files);
  attach();
}

static void process_is_left_alone(void) {
  struct sigaction before[NSIG], after;
  mapd_client *client = NULL;
  for (int i = 1; i < NSIG; ++i) sigaction(i, NULL, &before[i]);
  CHECK(mapd_client_connect(name, NULL, PATIENCE, &client, &error) == MAPD_CODE_OK);
  CHECK(entries("/proc/self/task") == 3); /* this one, `.` and `..` */
  for (int i = 1; i < NSIG; ++i) {
    if (sigaction(i, NULL, &after) == 0) CHECK(after.sa_handler == before[i].sa_handler);
  }
  mapd_client_close(&client);
}

struct shared {
  const mapd_client *client;
  const mapd_snapshot *map;
};

static void *ask(void *argument) {
  const struct shared *shared = argument;
  size_t wrong = 0;
  for (int i = 0; i < QUERIES; ++i) {
    mapd_snapshot *newest = NULL;
    wrong += mapd_client_refresh(shared->client, &newest, NULL) != MAPD_CODE_OK;
    wrong += !answers(newest) || !answers(shared->map);
    mapd_snapshot_close(&newest);
  }
  return (void *)wrong;
}

static void swaps_are_seen(const char *swap) {
  mapd_client *client = NULL;
  mapd_snapshot *before = NULL, *after = NULL;
  mapd_events *events = NULL;
  mapd_event event;
  mapd_nearest hit;
  mapd_lane_facts facts;
  pthread_t threads[THREADS];
  CHECK(mapd_client_connect(name, NULL, PATIENCE, &client, &error) == MAPD_CODE_OK);
  CHECK(mapd_client_snapshot(client, &before, &error) == MAPD_CODE_OK);
  CHECK(mapd_events_new(client, &events, &error) == MAPD_CODE_OK);
  CHECK(mapd_events_next(events, 0.0, &event, &error) == MAPD_CODE_NONE);
  CHECK(mapd_client_wait_next(client, 0.0, &after, &error) == MAPD_CODE_NO_GENERATION);
  struct shared shared = {client, before};
  for (int i = 0; i < THREADS; ++i) CHECK(pthread_create(&threads[i], NULL, ask, &shared) == 0);
  CHECK(system(swap) == 0);
  for (int i = 0; i < THREADS; ++i) {
    void *wrong;
    CHECK(pthread_join(threads[i], &wrong) == 0 && wrong == NULL);
  }
  CHECK(mapd_events_next(events, PATIENCE, &event, &error) == MAPD_CODE_OK && event.kind == MAPD_EVENT_GENERATION);
  CHECK(mapd_client_refresh(client, &after, &error) == MAPD_CODE_OK);
  /* What is held stays; its ids are of its own content. */
  CHECK(mapd_nearest_lane(before, POINT, NULL, &hit, &error) == MAPD_CODE_OK);
  CHECK(mapd_lane_facts_of(before, hit.lane, &facts, &error) == MAPD_CODE_OK);
  CHECK(mapd_lane_facts_of(after, hit.lane, &facts, &error) == MAPD_CODE_FOREIGN_ID);
  mapd_events_close(&events);
  mapd_client_close(&client);
  mapd_snapshot_close(&before);
  mapd_snapshot_close(&after);
}

static void what_is_proposed_is_decided(void) {
  static const char *const closed = "{\"id\":\"cones\",\"kind\":\"closed\",\"lanes\":[{\"road\":\"1\",\"s\":[10,20],\"lane\":-1}]}";
  static const char *const wet = "{\"id\":\"rain\",\"kind\":\"wet\",\"lanes\":[{\"road\":\"1\"}]}";
  mapd_client *client = NULL;
  mapd_decision decision = {0};
  uint8_t changed = 0;
  CHECK(mapd_client_connect(name, NULL, PATIENCE, &client, &error) == MAPD_CODE_OK);
  CHECK(mapd_propose(name, NULL, "tests", closed, PATIENCE, &decision, &error) == MAPD_CODE_OK && decision.is_accepted == 1);
  CHECK(mapd_client_wait_change(client, PATIENCE, &changed, &error) == MAPD_CODE_OK && changed == 1);
  CHECK(mapd_propose(name, NULL, "tests", wet, PATIENCE, &decision, &error) == MAPD_CODE_REFUSED && error.length > 0);
  CHECK(mapd_propose(name, NULL, "first", wet, PATIENCE, &decision, &error) == MAPD_CODE_OK);
  CHECK(decision.is_accepted == 0 && decision.agree == 1 && decision.needed == 2);
  CHECK(mapd_propose("nowhere", NULL, "tests", wet, PATIENCE, &decision, &error) == MAPD_CODE_NO_DAEMON);
  CHECK(mapd_propose(name, NULL, "two\nlines", wet, PATIENCE, &decision, &error) == MAPD_CODE_ARGUMENT);
  CHECK(mapd_propose(name, NULL, NULL, wet, PATIENCE, &decision, &error) == MAPD_CODE_NULL_POINTER);
  CHECK(mapd_propose(name, NULL, "tests", wet, -1.0, &decision, &error) == MAPD_CODE_ARGUMENT);
  mapd_client_close(&client);
}

static void forks_read_and_attach(void) {
  mapd_client *client = NULL;
  mapd_snapshot *map = NULL;
  int status = 0;
  CHECK(mapd_client_connect(name, NULL, PATIENCE, &client, &error) == MAPD_CODE_OK);
  CHECK(mapd_client_snapshot(client, &map, &error) == MAPD_CODE_OK);
  const pid_t child = fork();
  if (child == 0) {
    CHECK(answers(map));
    attach();
    mapd_snapshot_close(&map);
    mapd_client_close(&client);
    _exit(failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  CHECK(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS);
  CHECK(answers(map));
  mapd_snapshot_close(&map);
  mapd_client_close(&client);
}

static void what_is_held_outlives_the_daemon(pid_t daemon) {
  mapd_client *client = NULL;
  mapd_snapshot *map = NULL, *next = NULL;
  mapd_events *events = NULL;
  mapd_event event;
  uint32_t pid;
  double age = -1.0;
  CHECK(mapd_client_connect(name, NULL, PATIENCE, &client, &error) == MAPD_CODE_OK);
  CHECK(mapd_client_snapshot(client, &map, &error) == MAPD_CODE_OK);
  CHECK(mapd_events_new(client, &events, &error) == MAPD_CODE_OK);
  CHECK(mapd_client_served_by(client, &pid, &error) == MAPD_CODE_OK && pid == (uint32_t)daemon);
  CHECK(mapd_client_heartbeat_age(client, &age, &error) == MAPD_CODE_OK && age >= 0.0 && age < PATIENCE);
  CHECK(kill(daemon, SIGKILL) == 0);
  CHECK(mapd_events_next(events, PATIENCE, &event, &error) == MAPD_CODE_OK && event.kind == MAPD_EVENT_DAEMON_GONE);
  CHECK(mapd_client_served_by(client, &pid, &error) == MAPD_CODE_NONE);
  CHECK(mapd_client_wait_next(client, 0.0, &next, &error) == MAPD_CODE_NO_GENERATION);
  mapd_events_close(&events);
  mapd_client_close(&client);
  CHECK(answers(map));
  CHECK(mapd_snapshot_verify(map, &error) == MAPD_CODE_OK);
  mapd_snapshot_close(&map);
  CHECK(mappings() == 0);
}

int main(int argc, char **argv) {
  if (argc != 4) return EXIT_FAILURE;
  name = argv[1];
  process_is_left_alone();
  too_few_descriptors_are_an_error();
  nothing_is_left();
  forks_read_and_attach();
  what_is_proposed_is_decided();
  swaps_are_seen(argv[3]);
  what_is_held_outlives_the_daemon((pid_t)atoi(argv[2]));
  printf("service: %d failures\n", failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
