// The steps of an observer's attach in C, and nothing else: attach PREFIX MAP TIMES. Prints the nanoseconds of each attach, a line each. `attach.rs` compiles it.
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { PAGE = 4096, SLOT_WORDS = 55, LENGTH = 3, OFFSET = 18, INODE = 19, NAME_LENGTH = 20, NAME = 21 };

static void check(int holds, const char *what) {
    if (!holds) {
        perror(what);
        exit(1);
    }
}

static uint64_t now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (uint64_t)time.tv_sec * 1000000000u + (uint64_t)time.tv_nsec;
}

static int open_own(const char *path, uid_t us, struct stat *stat) {
    int file = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    check(file >= 0 && fstat(file, stat) == 0, path);
    check(stat->st_uid == us && S_ISREG(stat->st_mode), path);
    check(stat->st_blocks * 512 >= stat->st_size, path);
    return file;
}

int main(int count, char **arguments) {
    check(count == 4, "attach PREFIX MAP TIMES");
    char root[256], record_path[512], path[512];
    snprintf(root, sizeof root, "/dev/shm/%sroot", arguments[1]);
    snprintf(record_path, sizeof record_path, "%s/%s.published", root, arguments[2]);
    int times = atoi(arguments[3]);
    uint64_t sum = 0;
    for (int i = 0; i < times; i++) {
        uint64_t start = now();
        uid_t us = geteuid();
        struct statx folder;
        struct stat stat;
        check(statx(AT_FDCWD, root, AT_SYMLINK_NOFOLLOW, STATX_BASIC_STATS, &folder) == 0, root);
        check(folder.stx_uid == us && S_ISDIR(folder.stx_mode), root);
        int file = open_own(record_path, us, &stat);
        const uint8_t *record = mmap(NULL, PAGE, PROT_READ, MAP_SHARED, file, 0);
        check(record != MAP_FAILED, record_path);
        close(file);
        uint32_t sequence;
        uint64_t slot[SLOT_WORDS];
        memcpy(&sequence, record + 12, sizeof sequence);
        memcpy(slot, record + 24 + (sequence % 2) * sizeof slot, sizeof slot);
        snprintf(path, sizeof path, "/dev/shm/%.*s", (int)slot[NAME_LENGTH], (const char *)&slot[NAME]);
        file = open_own(path, us, &stat);
        check(stat.st_ino == slot[INODE], path);
        size_t length = slot[OFFSET] + slot[LENGTH];
        uint8_t *segment = mmap(NULL, length, PROT_READ, MAP_SHARED, file, 0);
        check(segment != MAP_FAILED, path);
        close(file);
        // Begins on a page.
        check(madvise(segment, (length + PAGE - 1) / PAGE * PAGE, MADV_DONTDUMP) == 0, path);
        // The header.
        for (int byte = 0; byte < 128; byte++) {
            sum += segment[slot[OFFSET] + byte];
        }
        printf("%llu\n", (unsigned long long)(now() - start));
        munmap(segment, length);
        munmap((void *)record, PAGE);
    }
    return sum == 0;
}
