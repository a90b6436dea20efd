/* The shared library, loaded and unloaded again and again, and two copies of it at once. `loaded LIBRARY COPY MAP`. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <mapd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TIMES = 20 };

/* Functions of one copy. */
struct library {
  void *handle;
  mapd_code (*connect)(const char *, const char *, double, mapd_client **, mapd_error *);
  mapd_code (*snapshot)(const mapd_client *, mapd_snapshot **, mapd_error *);
  mapd_code (*nearest)(const mapd_snapshot *, mapd_point, const mapd_nearest_options *, mapd_nearest *, mapd_error *);
  void (*close_client)(mapd_client **);
  void (*close_snapshot)(mapd_snapshot **);
};

static int find(struct library *of, void *function, const char *name) {
  void *found = dlsym(of->handle, name);
  /* ISO C has no conversion from a pointer to a function. */
  memcpy(function, &found, sizeof found);
  return found != NULL;
}

static int load(struct library *of, const char *path) {
  of->handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  return of->handle && find(of, &of->connect, "mapd_client_connect") && find(of, &of->snapshot, "mapd_client_snapshot") &&
         find(of, &of->nearest, "mapd_nearest_lane") && find(of, &of->close_client, "mapd_client_close") &&
         find(of, &of->close_snapshot, "mapd_snapshot_close");
}

static int ask(const struct library *of, const char *map) {
  mapd_client *client = NULL;
  mapd_snapshot *snapshot = NULL;
  mapd_nearest hit;
  mapd_error error;
  const mapd_point point = {50.0, -1.75, 0.0, 0};
  const int good = of->connect(map, NULL, 60.0, &client, &error) == MAPD_CODE_OK &&
                   of->snapshot(client, &snapshot, &error) == MAPD_CODE_OK &&
                   of->nearest(snapshot, point, NULL, &hit, &error) == MAPD_CODE_OK;
  of->close_snapshot(&snapshot);
  of->close_client(&client);
  return good;
}

static int is_mapped(const char *path) {
  char line[4096];
  int found = 0;
  FILE *file = fopen("/proc/self/maps", "r");
  while (file && fgets(line, sizeof line, file)) found |= strstr(line, path) != NULL;
  if (file) fclose(file);
  return found;
}

int main(int argc, char **argv) {
  struct library one, other;
  if (argc != 4) return EXIT_FAILURE;
  for (int i = 0; i < TIMES; ++i) {
    if (!load(&one, argv[1]) || !ask(&one, argv[3]) || dlclose(one.handle) != 0 || is_mapped(argv[1])) {
      fprintf(stderr, "time %d: %s\n", i, is_mapped(argv[1]) ? "not unloaded" : "failed");
      return EXIT_FAILURE;
    }
  }
  if (!load(&one, argv[1]) || !load(&other, argv[2]) || one.connect == other.connect) return EXIT_FAILURE;
  if (!ask(&one, argv[3]) || !ask(&other, argv[3]) || !ask(&one, argv[3])) return EXIT_FAILURE;
  dlclose(other.handle);
  dlclose(one.handle);
  printf("loaded: %d times, then two at once\n", TIMES);
  return EXIT_SUCCESS;
}
