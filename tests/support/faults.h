/* One call with its allocations failing one after another, inside an ordinary test. */
#ifndef TESTS_SUPPORT_FAULTS_H
#define TESTS_SUPPORT_FAULTS_H
#include "support/test.h"

/*
 * The call is made with its 1st allocation failing, then with its 2nd, and so on, until it
 * succeeds: because none was left to fail, or because it can do without the one that failed.
 * Each time before that it must report BATTEN_OUT_OF_MEMORY and give back all it took. The
 * first 100 allocations each have their turn, later ones in steps of an eighth.
 */
#define CHECK_EACH_ALLOCATION(call) TEST_FAULTS(call, false)

/*
 * The same for a call that keeps nothing and that looks at its result where it succeeds: goes on
 * beyond allocations that it can do without. A failure that is passed over, so that the result is
 * another one, is noticed by that look alone.
 */
#define CHECK_ALL_ALLOCATIONS(call) TEST_FAULTS(call, true)

#define TEST_FAULTS(call, beyond)                                        \
    do {                                                                 \
        test_fault fault_ = {.goes_on = beyond};                         \
        do {                                                             \
            test_fault_arm(&fault_);                                     \
            fault_.status = (call);                                      \
        } while (test_fault_struck(&fault_, #call, __FILE__, __LINE__)); \
    } while (0)

typedef struct test_fault {
    bool goes_on; /* beyond a success without the allocation that failed */
    long at;      /* which allocation of the call fails, from 1 */
    int live;     /* blocks before the call */
    batten_status status;
} test_fault;

void test_fault_arm(test_fault *f);
/* Whether an allocation failed, so that the next has to be tried; ends the test when the call
 * did not report it. */
bool test_fault_struck(const test_fault *f, const char *text, const char *file, int line);

#endif
