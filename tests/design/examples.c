/* The examples of the manual: see examples.h. */
#include "design/examples.h"
#include "design/evaluate.h"

void make_example(const char *name, bool quiet)
{
    char text[8000];
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    const batten_feature *feature = batten_feature_find(name);
    CHECK(feature != NULL);
    snprintf(text, sizeof text, "batten: 1\n%s", feature->example);
    CHECK_OK(batten_notes_create(50, &notes));
    batten_status status = evaluate_design(text, NULL, notes, &design);
    if (test_memory_failed(status, BATTEN_OK)) {
        batten_notes_free(notes); /* those of the first attempt */
        CHECK_OK(batten_notes_create(50, &notes));
        status = evaluate_design(text, NULL, notes, &design);
    }
    CHECK_OK(status);
    for (int i = 0; i < batten_design_result_count(design); i++) {
        const batten_feature_result *result = batten_design_result_at(design, i);
        CHECK(result->value && batten_model_count(result->value) > 0);
    }
    CHECK(!quiet || batten_notes_count(notes) == 0);
    batten_design_free(design);
    batten_notes_free(notes);
}
