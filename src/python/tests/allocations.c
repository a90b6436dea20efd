/* Counts allocations of at least so many bytes: a library that is loaded before all others (LD_PRELOAD). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <stddef.h>

/* The C library's own, by names that it has for such libraries. */
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

static atomic_size_t least = (size_t)-1, count = 0;

/* From now on what has at least so many bytes is counted, from 0. */
void count_from(size_t bytes) {
  least = bytes;
  count = 0;
}

size_t counted(void) { return count; }

static void see(size_t size) {
  if (size >= least) ++count;
}

void *malloc(size_t size) {
  see(size);
  return __libc_malloc(size);
}

void *calloc(size_t number, size_t size) {
  see(size != 0 && number > (size_t)-1 / size ? (size_t)-1 : number * size);
  return __libc_calloc(number, size);
}

void *realloc(void *old, size_t size) {
  see(size);
  return __libc_realloc(old, size);
}

int posix_memalign(void **out, size_t alignment, size_t size) {
  see(size);
  *out = __libc_memalign(alignment, size);
  return *out ? 0 : ENOMEM;
}

void *aligned_alloc(size_t alignment, size_t size) {
  see(size);
  return __libc_memalign(alignment, size);
}
