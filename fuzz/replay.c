/* Give each file of the folders named to the target, once: so that corpora are tests under any
 * compiler. With --damage COUNT: so many damaged copies of them instead, the same in every run;
 * --first N begins with the Nth of them. With --faults COUNT: each file is read with so many of
 * its allocations failing, one after another, and with low limits. */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "faults.h"
#include "mutate.h"
#include "promise.h"
#include "survive.h"

#include <batten/text.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#define FILES 4096
#define LARGEST 16384 /* seed that is damaged */
#define MOST 65536    /* bytes of a damaged file */
#define SECONDS 5     /* of processor time for one: a loaded machine is no fault of the file */

typedef struct {
    char *name;
    uint8_t *bytes; /* without the byte that follows: reading past the end shows */
    size_t size;
} seed;
typedef struct {
    seed files[FILES];
    int count;
} seeds;

static void *must(void *memory)
{
    if (memory)
        return memory;
    fputs("no memory\n", stderr);
    exit(1);
}

static int compare(const void *a, const void *b)
{
    return strcmp(((const seed *)a)->name, ((const seed *)b)->name);
}

static void load(seeds *all, const char *path)
{
    char *data = NULL;
    seed *file = &all->files[all->count];
    if (all->count == FILES)
        return;
    if (batten_load_file(path, (size_t)1 << 30, &data, &file->size) != BATTEN_OK) {
        fprintf(stderr, "%s\n", batten_message());
        exit(1);
    }
    file->bytes = must(malloc(file->size ? file->size : 1));
    memcpy(file->bytes, data, file->size);
    batten_release(data);
    file->name = must(strdup(path));
    all->count++;
}

static void load_folder(seeds *all, const char *folder)
{
    DIR *directory = opendir(folder);
    if (!directory) {
        perror(folder);
        exit(1);
    }
    for (const struct dirent *entry; (entry = readdir(directory));) {
        char path[1024];
        if (entry->d_name[0] == '.')
            continue;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        load(all, path);
    }
    closedir(directory);
}

static void drop(seeds *all, int index)
{
    free(all->files[index].bytes);
    free(all->files[index].name);
    all->files[index] = all->files[--all->count];
}

/* ---- damage ---- */

static batten_format format_of(const char *name)
{
    for (int k = BATTEN_FORMAT_AUTO; strcmp(batten_format_name((batten_format)k), "?"); k++)
        if (strcmp(batten_format_name((batten_format)k), name) == 0)
            return (batten_format)k;
    return BATTEN_FORMAT_AUTO;
}

/* The Nth damaged file: a copy of one of the seeds with one to four changes. */
static uint8_t *make_damaged(const seeds *all, size_t number, size_t *size)
{
    const fuzz_grammar *grammar = fuzz_grammar_of(FUZZ_NAME);
    fuzz_random random = fuzz_random_begin(number);
    const seed *file = &all->files[number % (size_t)all->count];
    const seed *other = &all->files[fuzz_random_below(&random, (size_t)all->count)];
    uint8_t *room = must(malloc(MOST));
    *size = file->size < MOST ? file->size : MOST;
    memcpy(room, file->bytes, *size);
    const size_t changes = 1 + fuzz_random_below(&random, 4);
    for (size_t i = 0; i < changes; i++)
        *size = fuzz_mutate(grammar, room, *size, MOST, random.state, other->bytes, other->size,
                            NULL),
        fuzz_random_below(&random, 2);
    uint8_t *exact = must(malloc(*size ? *size : 1));
    memcpy(exact, room, *size);
    free(room);
    return exact;
}

/* SIGPROF ends the process after so much processor time; 0: never. */
static void allow_seconds(int seconds)
{
    const struct itimerval limit = {.it_value = {.tv_sec = seconds}};
    setitimer(ITIMER_PROF, &limit, NULL);
}

static void try_all(const seeds *all, size_t first, size_t count, volatile size_t *reached)
{
    const batten_format format = format_of(FUZZ_NAME);
    for (size_t i = first; i < first + count; i++) {
        size_t size;
        *reached = i;
        uint8_t *damaged = make_damaged(all, i, &size);
        allow_seconds(SECONDS);
        LLVMFuzzerTestOneInput(damaged, size);
        if (format != BATTEN_FORMAT_AUTO)
            fuzz_survive(damaged, size, format);
        free(damaged);
    }
    allow_seconds(0);
}

/* Keep what a reader did not survive, and say how to come back to it. */
static void report(const seeds *all, size_t number, int status)
{
    size_t size;
    uint8_t *damaged = make_damaged(all, number, &size);
    fprintf(stderr, "damaged file %zu, of %s, was not survived: %s %d; it is in damaged-%s\n",
            number, all->files[number % (size_t)all->count].name,
            WIFSIGNALED(status) ? "signal" : "exit status",
            WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status), FUZZ_NAME);
    fprintf(stderr, "again: replay-%s --damage 1 --first %zu FOLDER...\n", FUZZ_NAME, number);
    FILE *file = fopen("damaged-" FUZZ_NAME, "wb");
    if (file) {
        fwrite(damaged, 1, size, file);
        fclose(file);
    }
    free(damaged);
}

/* In a process of its own, so that its end can be told. */
static int survive_damage(const seeds *all, size_t first, size_t count)
{
    int status = 0;
    size_t *reached =
        mmap(NULL, sizeof *reached, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (reached == MAP_FAILED)
        return 1;
    *reached = first;
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        try_all(all, first, count, reached);
        _exit(0);
    }
    if (child < 0 || waitpid(child, &status, 0) != child)
        return 1;
    if (status != 0)
        report(all, *reached, status);
    else
        printf("%zu damaged copies of %d files survived\n", count, all->count);
    munmap(reached, sizeof *reached);
    return status != 0;
}

static int survive_faults(const seeds *all, long most)
{
    int status = 0;
    const batten_format format = format_of(FUZZ_NAME);
    for (int i = 0; i < all->count && format != BATTEN_FORMAT_AUTO; i++) {
        const seed *file = &all->files[i];
        status |= !fuzz_faults(file->name, file->bytes, file->size, format, most);
        status |= !fuzz_limits(file->name, file->bytes, file->size, format);
    }
    printf("%d files read with failing memory and low limits\n", all->count);
    return status;
}

static void replay(const seeds *all)
{
    for (int i = 0; i < all->count; i++)
        LLVMFuzzerTestOneInput(all->files[i].bytes, all->files[i].size);
    printf("%d files replayed\n", all->count);
}

int main(int count, char **words)
{
    static seeds all;
    size_t damaged = 0, first = 0;
    long faults = 0;
    int status = 0;
    fuzz_faults_begin();
    for (int i = 1; i < count; i++) {
        if (strcmp(words[i], "--damage") == 0 && i + 1 < count)
            damaged = (size_t)strtoul(words[++i], NULL, 10);
        else if (strcmp(words[i], "--first") == 0 && i + 1 < count)
            first = (size_t)strtoul(words[++i], NULL, 10);
        else if (strcmp(words[i], "--faults") == 0 && i + 1 < count)
            faults = strtol(words[++i], NULL, 10);
        else
            load_folder(&all, words[i]);
    }
    for (int i = all.count; damaged > 0 && i-- > 0;)
        if (all.files[i].size > LARGEST)
            drop(&all, i);
    /* Folders have no order of their own. */
    qsort(all.files, (size_t)all.count, sizeof all.files[0], compare);
    if (damaged > 0 && all.count > 0)
        status = survive_damage(&all, first, damaged);
    else if (faults > 0)
        status = survive_faults(&all, faults);
    else
        replay(&all);
    if (all.count == 0)
        status = 1;
    while (all.count > 0)
        drop(&all, 0);
    return status;
}
