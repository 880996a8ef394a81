/*
 * The test kit: cmocka runs the tests, this registers and checks them.
 *
 *     TEST(an_arc_stays_on_its_circle) { ... CHECK_OK(batten_curve_arc(1, 1, &arc)); ... }
 *
 * Every test is also run with its allocations failing one after another (`--faults`). Then a
 * call under CHECK_OK or CHECK_STATUS that reports BATTEN_OUT_OF_MEMORY is made a second time,
 * which must succeed: so the failed call left everything as it was. When all later allocations
 * fail too, the test ends there. In every run all memory must have been given back at the end.
 */
#ifndef TESTS_SUPPORT_TEST_H
#define TESTS_SUPPORT_TEST_H
#include <batten/base.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Whether a sanitizer stands between the tests and their memory and threads: gcc says so by a macro, clang by a feature. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { SANITIZED = 1 };
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
enum { SANITIZED = 1 };
#else
enum { SANITIZED = 0 };
#endif
#else
enum { SANITIZED = 0 };
#endif

#define COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

typedef struct test_entry {
    const char *name, *file;
    void (*run)(void);
    struct test_entry *next;
} test_entry;
void test_register(test_entry *entry);

#define TEST(name)                                                  \
    static void name(void);                                         \
    static test_entry name##_entry = {#name, __FILE__, name, NULL}; \
    __attribute__((constructor)) static void name##_register(void)  \
    {                                                               \
        test_register(&name##_entry);                               \
    }                                                               \
    static void name(void)

/* ---- checks; a failing one ends the test ---- */

#define CHECK(condition) test_check(condition, #condition, __FILE__, __LINE__)
#define CHECK_OK(call) CHECK_STATUS(call, BATTEN_OK)
#define CHECK_STATUS(call, expected)                               \
    do {                                                           \
        batten_status status_ = (call);                            \
        if (test_memory_failed(status_, expected))                 \
            status_ = (call);                                      \
        test_status(status_, expected, #call, __FILE__, __LINE__); \
    } while (0)
#define CHECK_INT(actual, expected) test_int(actual, expected, #actual, __FILE__, __LINE__)
#define CHECK_NEAR(actual, expected, tolerance) \
    test_near(actual, expected, tolerance, #actual, __FILE__, __LINE__)
/* The same bits: 0 and -0 differ. */
#define CHECK_BITS(actual, expected) test_bits(actual, expected, #actual, __FILE__, __LINE__)
#define CHECK_TEXT(actual, expected) test_text(actual, expected, #actual, __FILE__, __LINE__)
/* Does the message of the last failure contain these words? */
#define CHECK_MESSAGE(words) test_contains(batten_message(), words, __FILE__, __LINE__)
#define CHECK_CONTAINS(text, words) test_contains(text, words, __FILE__, __LINE__)
/* End the test here, saying why; for what a machine may lack. */
#define SKIP(...) test_skip(__VA_ARGS__)

void test_check(bool holds, const char *text, const char *file, int line);
bool test_memory_failed(batten_status status, batten_status expected);
void test_status(batten_status actual, batten_status expected, const char *text,
                 const char *file, int line);
void test_int(long long actual, long long expected, const char *text, const char *file,
              int line);
void test_near(double actual, double expected, double tolerance, const char *text,
               const char *file, int line);
void test_bits(double actual, double expected, const char *text, const char *file, int line);
void test_text(const char *actual, const char *expected, const char *text, const char *file,
               int line);
void test_contains(const char *text, const char *words, const char *file, int line);
_Noreturn void test_skip(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* ---- helpers ---- */

/* Zeroed memory for the test itself; never fails and is given back when the test ends. */
void *test_array(size_t count, size_t size);

/* Let the `at`-th allocation from here on fail; 0: none. For tests that state what becomes of it,
 * and that skip themselves in runs whose allocations fail anyway. */
void test_fail_allocation(long at);
/* How many there have been since. */
long test_allocations(void);

/* How many random cases to try where `usual` are usual: BATTEN_CASES multiplies it, and runs
 * with failing allocations take two. */
int test_cases(int usual);

/* The path of a file of the shared data, or SKIP when it is absent. */
const char *test_data(const char *path);
/* The path of a file of this repository. */
const char *test_source(const char *path);
/* The path of a file that the test may write; removed when the run ends. */
const char *test_scratch(const char *name);

/* Random numbers: xorshift64*, the same for every run unless BATTEN_SEED is set. */
typedef struct test_random {
    uint64_t state;
} test_random;
test_random test_random_begin(const char *name); /* seeds by the name and BATTEN_SEED */
uint64_t test_random_bits(test_random *random);
double test_random_unit(test_random *random);                   /* [0, 1) */
double test_random_in(test_random *random, double a, double b); /* [a, b) */
int test_random_int(test_random *random, int a, int b);         /* a .. b */

#endif
