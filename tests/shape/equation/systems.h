/* Systems of equations read from texts, for tests of what traces them. */
#ifndef TESTS_EQUATION_SYSTEMS_H
#define TESTS_EQUATION_SYSTEMS_H
#include "shape/equation/system.h"

#include "support/test.h"

typedef struct {
    batten_equation *read[BAT_EQUATIONS];
    bat_system system;
} test_system;

/* One equation in x and y, or two in x, y and z. */
static inline void begin_test_system(test_system *s, const char *first, const char *second)
{
    static const char *const variables[] = {"x", "y", "z"};
    const int count = second ? 2 : 1;
    const char *const texts[] = {first, second};
    const batten_equation_names names = {count + 1, 0, variables, NULL};
    *s = (test_system){{NULL, NULL}, {0}};
    for (int i = 0; i < count; i++)
        CHECK_OK(batten_equation_read(texts[i], &names, &s->read[i]));
    bat_system_begin(&s->system, count, (const batten_equation *const *)s->read);
}

static inline void end_test_system(test_system *s)
{
    for (int i = 0; i < BAT_EQUATIONS; i++)
        batten_equation_free(s->read[i]);
}

#endif
