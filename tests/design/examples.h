/* The examples of the manual, feature by feature: small tests, whose allocations can fail one by one. */
#ifndef TESTS_DESIGN_EXAMPLES_H
#define TESTS_DESIGN_EXAMPLES_H
#include "support/test.h"

/* Evaluate all features of the example; each makes at least one object. `quiet`: there is nothing to note. */
void make_example(const char *feature, bool quiet);

#define EXAMPLE(name, feature)                  \
    TEST(the_example_of_##name##_makes_objects) \
    {                                           \
        make_example(feature, false);           \
    }
#define QUIET_EXAMPLE(name, feature)                     \
    TEST(the_example_of_##name##_makes_objects_silently) \
    {                                                    \
        make_example(feature, true);                     \
    }

#endif
