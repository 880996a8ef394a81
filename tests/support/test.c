#define _XOPEN_SOURCE 700
#include "support/faults.h"

/* cmocka wants these before its header. */
#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>
#include <fnmatch.h>
#include <ftw.h>
#include <pthread.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

/* ---- memory that counts, and fails when told to ---- */

/* Behind the bytes stand numbers that are none: what is read there is no result, and a write is
 * noticed when the block is released. */
typedef struct block {
    struct block *previous, *next;
    size_t size;
    _Alignas(16) unsigned char bytes[];
} block;

typedef enum { NO_FAULT, ONE_FAULT, ALL_FAULTS } fault_kind;

static pthread_mutex_t memory_lock = PTHREAD_MUTEX_INITIALIZER;
static block live = {&live, &live, 0};
static long allocation_count, fail_at;
static fault_kind fault;
static bool fault_mode;

static block *header(void *memory)
{
    return (block *)(void *)((unsigned char *)memory - offsetof(block, bytes));
}

static void unlink_block(block *b)
{
    b->previous->next = b->next;
    b->next->previous = b->previous;
}

/* Signalling NaNs: any sum changes their bits. */
#define SIGNALLING UINT64_C(0x7ff45a5a5a5a5a5a)
static const uint64_t guard[] = {SIGNALLING, SIGNALLING, SIGNALLING, SIGNALLING,
                                 SIGNALLING, SIGNALLING, SIGNALLING, SIGNALLING};
static int overrun_count;
static size_t overrun_size; /* of the last one */

static void set_guard(block *b, size_t size)
{
    b->size = size;
    memcpy(b->bytes + size, guard, sizeof guard);
}

static void check_guard(const block *b)
{
    if (memcmp(b->bytes + b->size, guard, sizeof guard) == 0)
        return;
    overrun_count++;
    overrun_size = b->size;
}

static bool must_fail(void)
{
    allocation_count++;
    return (fault == ONE_FAULT && allocation_count == fail_at) ||
           (fault == ALL_FAULTS && allocation_count >= fail_at);
}

static void *counting_resize(void *user, void *memory, size_t bytes)
{
    (void)user;
    pthread_mutex_lock(&memory_lock);
    block *b = NULL;
    if (!must_fail() && bytes <= SIZE_MAX / 2) {
        block *old = memory ? header(memory) : NULL;
        if (old) {
            unlink_block(old);
            check_guard(old);
        }
        b = realloc(old, offsetof(block, bytes) + bytes + sizeof guard);
        if (b)
            set_guard(b, bytes);
        block *kept = b ? b : old;
        if (kept) {
            kept->next = live.next;
            kept->previous = &live;
            live.next->previous = kept;
            live.next = kept;
        }
    }
    pthread_mutex_unlock(&memory_lock);
    return b ? b->bytes : NULL;
}

static void counting_release(void *user, void *memory)
{
    (void)user;
    pthread_mutex_lock(&memory_lock);
    unlink_block(header(memory));
    check_guard(header(memory));
    free(header(memory));
    pthread_mutex_unlock(&memory_lock);
}

static int release_all(void)
{
    int count = 0;
    while (live.next != &live) {
        counting_release(NULL, live.next->bytes);
        count++;
    }
    return count;
}

void test_fail_allocation(long at)
{
    pthread_mutex_lock(&memory_lock);
    fault = at > 0 ? ONE_FAULT : NO_FAULT;
    fail_at = at;
    allocation_count = 0;
    pthread_mutex_unlock(&memory_lock);
}

long test_allocations(void)
{
    return allocation_count;
}

/* ---- the running test ---- */

static test_entry *entries;
static jmp_buf end_of_test;
static bool test_running;
static int skipped_count;
static void *arrays[1024];
static int array_count;
static char scratch[64];

void test_register(test_entry *entry)
{
    test_entry **place = &entries;
    while (*place)
        place = &(*place)->next;
    *place = entry;
}

static void release_arrays(void)
{
    while (array_count > 0)
        free(arrays[--array_count]);
}

/* Run once; true when the body ran to its end. */
static bool run_once(const test_entry *test, fault_kind kind, long at)
{
    fault = kind;
    fail_at = at;
    allocation_count = 0;
    volatile bool whole = false;
    release_all(); /* what a failed test before this one held */
    overrun_count = 0;
    test_running = true;
    if (setjmp(end_of_test) == 0) {
        test->run();
        whole = true;
    }
    test_running = false;
    fault = NO_FAULT;
    release_arrays();
    const int leaked = release_all();
    if (overrun_count)
        fail_msg("%s: %d blocks of memory were written beyond their end, one of %zu bytes",
                 test->name, overrun_count, overrun_size);
    if (leaked && whole)
        fail_msg("%s: %d blocks of memory were not given back (%s allocation %ld)", test->name,
                 leaked, kind == NO_FAULT ? "no failing" : "failing", at);
    return whole;
}

/* Seconds that one test may spend on failing allocations; 0 for as many as it takes. */
static double fault_seconds(void)
{
    const char *seconds = getenv("BATTEN_FAULT_SECONDS");
    return seconds ? atof(seconds) : 1;
}

/* Seconds of the processor: what a test may spend does not depend on what runs beside it. */
static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

static long greatest_divisor(long a, long b)
{
    while (b) {
        const long rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* Each place once, in steps of the golden section: wherever time runs out, those that were
 * tried lie evenly over the whole test, the last one among them. */
static void run_with_faults(const test_entry *test, long count, double plain_seconds)
{
    const double limit = fault_seconds(), begin = now();
    const int at_least = limit >= 1 ? 8 : plain_seconds > limit ? 1 : 2;
    long step = (long)(0.6180339887498949 * (double)count), tried = 0;
    while (greatest_divisor(count, step) != 1)
        step++;
    for (long at = count; tried < count;
         at = (at + step) % count ? (at + step) % count : count) {
        if (limit > 0 && tried >= at_least && now() - begin > limit)
            break;
        run_once(test, ONE_FAULT, at);
        run_once(test, ALL_FAULTS, at);
        tried++;
    }
    if (tried < count)
        print_message("[  SAMPLED ] %s: %ld of %ld allocations failed\n", test->name, tried,
                      count);
}

static void run_entry(void **state)
{
    const test_entry *test = *state;
    const double begin = now();
    if (run_once(test, NO_FAULT, 0) && fault_mode)
        run_with_faults(test, allocation_count, now() - begin);
}

/* ---- checks ---- */

static _Noreturn void failed(const char *file, int line)
{
    print_error("%s:%d: seed %s\n", file, line,
                getenv("BATTEN_SEED") ? getenv("BATTEN_SEED") : "0");
    _fail(file, line);
    abort();
}

void test_check(bool holds, const char *text, const char *file, int line)
{
    if (holds)
        return;
    print_error("does not hold: %s\n", text);
    failed(file, line);
}

bool test_memory_failed(batten_status status, batten_status expected)
{
    if (fault == NO_FAULT || status != BATTEN_OUT_OF_MEMORY || expected == BATTEN_OUT_OF_MEMORY)
        return false;
    if (fault == ALL_FAULTS)
        longjmp(end_of_test, 1);
    return true;
}

void test_status(batten_status actual, batten_status expected, const char *text,
                 const char *file, int line)
{
    if (actual == expected)
        return;
    print_error("%s\n  gave %s, not %s; message: %s\n", text, batten_status_name(actual),
                batten_status_name(expected), batten_message());
    failed(file, line);
}

/* ---- one call with failing allocations ---- */

static int live_count(void)
{
    int count = 0;
    for (const block *b = live.next; b != &live; b = b->next)
        count++;
    return count;
}

/* Where the whole test runs with failing allocations, the call succeeds or ends the test as
 * under CHECK_OK, and nothing is armed here. */
void test_fault_arm(test_fault *f)
{
    f->live = live_count();
    if (fault_mode)
        return;
    f->at += f->at < 100 ? 1 : f->at / 8;
    fault = ONE_FAULT;
    fail_at = allocation_count + f->at;
}

bool test_fault_struck(const test_fault *f, const char *text, const char *file, int line)
{
    if (fault_mode && test_memory_failed(f->status, BATTEN_OK))
        return true;
    const bool struck = !fault_mode && allocation_count >= fail_at;
    if (!fault_mode)
        fault = NO_FAULT;
    if (struck && f->goes_on && f->status == BATTEN_OK)
        return true;
    if (!struck || f->status != BATTEN_OUT_OF_MEMORY) {
        test_status(f->status, BATTEN_OK, text, file, line);
        return false;
    }
    const int kept = live_count() - f->live;
    if (kept == 0)
        return true;
    print_error("%s\n  with allocation %ld failing kept %d blocks\n", text, f->at, kept);
    failed(file, line);
}

void test_int(long long actual, long long expected, const char *text, const char *file,
              int line)
{
    if (actual == expected)
        return;
    print_error("%s is %lld, not %lld\n", text, actual, expected);
    failed(file, line);
}

void test_near(double actual, double expected, double tolerance, const char *text,
               const char *file, int line)
{
    if (fabs(actual - expected) <= tolerance)
        return;
    print_error("%s is %.17g, not %.17g: off by %.3g, allowed %.3g\n", text, actual, expected,
                actual - expected, tolerance);
    failed(file, line);
}

void test_bits(double actual, double expected, const char *text, const char *file, int line)
{
    if (memcmp(&actual, &expected, sizeof actual) == 0)
        return;
    print_error("%s is %.17g (%a), not %.17g (%a)\n", text, actual, actual, expected, expected);
    failed(file, line);
}

void test_text(const char *actual, const char *expected, const char *text, const char *file,
               int line)
{
    if (actual && strcmp(actual, expected) == 0)
        return;
    print_error("%s is \"%s\",\n not \"%s\"\n", text, actual ? actual : "(null)", expected);
    failed(file, line);
}

void test_contains(const char *text, const char *words, const char *file, int line)
{
    if (text && strstr(text, words))
        return;
    print_error("\"%s\"\n does not contain \"%s\"\n", text ? text : "(null)", words);
    failed(file, line);
}

void test_skip(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char text[512];
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    print_message("[  SKIPPED ] %s\n", text);
    skipped_count++;
    longjmp(end_of_test, 1);
}

/* ---- helpers ---- */

void *test_array(size_t count, size_t size)
{
    void *array = calloc(count ? count : 1, size);
    if (!array || array_count == COUNT(arrays))
        abort();
    return arrays[array_count++] = array;
}

int test_cases(int usual)
{
    if (fault != NO_FAULT || fault_mode)
        return usual < 2 ? usual : 2;
    const char *factor = getenv("BATTEN_CASES");
    return factor ? usual * atoi(factor) : usual;
}

static char *joined(const char *folder, const char *path)
{
    const size_t size = strlen(folder) + strlen(path) + 2;
    char *whole = test_array(size, 1);
    snprintf(whole, size, "%s/%s", folder, path);
    return whole;
}

const char *test_source(const char *path)
{
    return joined(TESTS_SOURCE, path);
}

const char *test_data(const char *path)
{
    const char *whole = joined(TESTS_SOURCE "/../shared/data", path);
    if (access(whole, R_OK) != 0)
        SKIP("the shared data file %s is absent", path);
    return whole;
}

static int remove_entry(const char *path, const struct stat *status, int kind,
                        struct FTW *place)
{
    (void)status, (void)kind, (void)place;
    return remove(path);
}

static void remove_scratch(void)
{
    nftw(scratch, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
}

const char *test_scratch(const char *name)
{
    if (!*scratch) {
        strcpy(scratch, "/tmp/batten-test-XXXXXX");
        if (!mkdtemp(scratch))
            abort();
        atexit(remove_scratch);
    }
    return joined(scratch, name);
}

test_random test_random_begin(const char *name)
{
    const char *seed = getenv("BATTEN_SEED");
    uint64_t state = 0x9e3779b97f4a7c15u + (seed ? strtoull(seed, NULL, 10) : 0);
    for (const char *c = name; *c; c++)
        state = (state ^ (unsigned char)*c) * 0x100000001b3u;
    return (test_random){state ? state : 1};
}

uint64_t test_random_bits(test_random *random)
{
    uint64_t x = random->state;
    x ^= x >> 12;
    x ^= x << 25;
    x ^= x >> 27;
    random->state = x;
    return x * 0x2545f4914f6cdd1du;
}

double test_random_unit(test_random *random)
{
    return (double)(test_random_bits(random) >> 11) * 0x1p-53;
}

double test_random_in(test_random *random, double a, double b)
{
    return a + (b - a) * test_random_unit(random);
}

int test_random_int(test_random *random, int a, int b)
{
    return a + (int)(test_random_bits(random) % (uint64_t)(b - a + 1));
}

/* ---- main ---- */

/* Is the test in this room, the folder below tests/ in which its file stands? A compiler may be
 * given paths from any folder on, so what precedes the last "tests/" does not matter. */
static bool is_in_room(const test_entry *test, const char *room)
{
    const char *path = NULL;
    for (const char *at = test->file; (at = strstr(at, "tests/")) != NULL; at++)
        path = at + strlen("tests/");
    const char *slash = path ? strrchr(path, '/') : NULL;
    return slash && (size_t)(slash - path) == strlen(room) &&
           strncmp(path, room, strlen(room)) == 0;
}

/* `--room shape/skin`: the tests of that folder alone, without those of folders below it.
 * `--part 1/3`: each third test, from the first on, so that several processes share the work.
 * Any other argument is a pattern of the names of those tests that run, or of a part of them;
 * that none matches is a failure.
 */
int main(int argument_count, char **arguments)
{
    unsigned part = 1, parts = 1, index = 0;
    const char *room = NULL;
    char name[200] = "*";
    for (int i = 1; i < argument_count; i++) {
        if (strcmp(arguments[i], "--faults") == 0)
            fault_mode = true;
        else if (strcmp(arguments[i], "--part") == 0 && i + 1 < argument_count) {
            if (sscanf(arguments[++i], "%u/%u", &part, &parts) != 2 || part < 1 || part > parts)
                return 2;
        } else if (strcmp(arguments[i], "--room") == 0 && i + 1 < argument_count)
            room = arguments[++i];
        else
            snprintf(name, sizeof name, "*%s*", arguments[i]);
    }
    const char *program = strrchr(arguments[0], '-');
    const char *group = room ? room : program ? program + 1 : arguments[0];
    const batten_allocator counting = {counting_resize, counting_release, NULL};
    batten_set_allocator(&counting);

    static struct CMUnitTest tests[2048];
    size_t count = 0;
    for (test_entry *e = entries; e; e = e->next)
        if ((!room || is_in_room(e, room)) && fnmatch(name, e->name, 0) == 0 &&
            index++ % parts == part - 1) {
            if (count == sizeof tests / sizeof tests[0])
                abort();
            tests[count++] = (struct CMUnitTest){e->name, run_entry, NULL, NULL, e};
        }
    const int failures = _cmocka_run_group_tests(group, tests, count, NULL, NULL);
    printf("%s: %d passed, %d failed, %d skipped\n", group,
           (int)count - failures - skipped_count, failures, skipped_count);
    return failures != 0 || count == 0;
}
