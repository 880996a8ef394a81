/* What expect.c and facts.c share: one fact of a row, and how it is compared. */
#ifndef TESTS_DESIGN_FACTS_H
#define TESTS_DESIGN_FACTS_H
#include "design/expect.h"

enum { FACT_NUMBERS = 8 };

/* The row under test, and the object that its facts are about. */
typedef struct {
    const char *feature;
    const batten_feature_result *result;
    const batten_object *object;
    const batten_notes *notes;
    double within;
} subject;

typedef struct {
    char word[24];
    const char *rest; /* after the word */
    int count;
    double number[FACT_NUMBERS];
} fact;

typedef struct {
    const char *word;
    void (*check)(subject *of, const fact *f);
} known_fact;

const batten_object *fact_object(const subject *of, double index);
/* What is wrong is listed and counted; the table fails at its end. */
void fact_near(const subject *of, const fact *f, double actual, double expected);
void fact_near_point(const subject *of, const fact *f, const double *actual,
                     const double *expected);

/* Facts of places, lengths and areas. */
extern const known_fact geometry_facts[];
extern const int geometry_fact_count;

#endif
