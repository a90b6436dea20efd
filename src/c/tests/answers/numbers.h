/* Questions with their answers by Rust, one a line: see the program `answers` of the crate mapd-tests. For C and C++. */
#ifndef MAPD_TEST_ANSWERS_H
#define MAPD_TEST_ANSWERS_H

/* For getline; g++ defines it by itself. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of a question or answer. */
struct numbers {
  uint64_t *all;
  size_t count, room;
};

static inline void add_u(struct numbers *to, uint64_t number) {
  if (to->count == to->room) {
    to->room = to->room ? 2 * to->room : 64;
    to->all = (uint64_t *)realloc(to->all, to->room * sizeof *to->all);
    if (!to->all) abort();
  }
  to->all[to->count++] = number;
}

static inline void add_f(struct numbers *to, double number) {
  uint64_t bits;
  memcpy(&bits, &number, sizeof bits);
  add_u(to, bits);
}

static inline double as_f(uint64_t bits) {
  double number;
  memcpy(&number, &bits, sizeof number);
  return number;
}

/* FNV-1a of a text. */
static inline uint64_t hash_of(const char *text, size_t size) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (size_t i = 0; i < size; ++i) hash = (hash ^ (uint8_t)text[i]) * 0x100000001b3u;
  return hash;
}

/* Reads a line into its kind, question and answer. 0 at the end. */
static inline int read_line(FILE *file, char **line, size_t *room, char **kind, struct numbers *question,
                            struct numbers *answer) {
  const ssize_t size = getline(line, room, file);
  if (size <= 0) return 0;
  question->count = answer->count = 0;
  char *at = *line;
  *kind = at;
  while (*at != ' ' && *at != '\0') ++at;
  struct numbers *to = question;
  if (*at != '\0') *at++ = '\0';
  while (*at != '\0' && *at != '\n') {
    if (*at == '|') {
      to = answer;
      ++at;
    } else if (*at == ' ') {
      ++at;
    } else {
      char *end;
      add_u(to, strtoull(at, &end, 16));
      if (end == at) abort();
      at = end;
    }
  }
  return 1;
}

/* Whether both are the same, bit by bit. */
static inline int same(const struct numbers *a, const struct numbers *b) {
  return a->count == b->count && (a->count == 0 || memcmp(a->all, b->all, a->count * sizeof *a->all) == 0);
}

#endif
