#include "support/test.h"

#include <batten/design.h>
#include <math.h>

static void open_boat(batten_design **out)
{
    char text[1000];
    snprintf(text, sizeof text,
             "batten: 1\nunits: in\ntolerance: 0.005 in\nfeatures:\n  table: {read: '%s'}\n"
             "  hull: {loft: table, within: 0.125 in, knuckles: chine}\n"
             "  faired: {faired-table: hull}\n  none: {faired-table: table}\n",
             test_source("examples/sharpie/offsets.csv"));
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, out));
}

static const batten_offset_table *table_of(batten_design *design, const char *feature)
{
    const batten_model *model = batten_design_result(design, feature)->value;
    CHECK_INT(batten_model_count(model), 1);
    return batten_model_object(model, 0)->offset_table;
}

TEST(a_faired_table_has_the_layout_of_its_table_and_lies_within_the_bound)
{
    batten_design *design = NULL;
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    open_boat(&design);
    CHECK_OK(batten_design_evaluate(design, "faired", NULL, NULL));
    const batten_offset_table *given = table_of(design, "table"),
                              *faired = table_of(design, "faired");
    CHECK_INT(batten_offset_table_station_count(faired), 8);
    CHECK_INT(batten_offset_table_line_count(faired), batten_offset_table_line_count(given));
    for (int k = 0; k < 8; k++) {
        const batten_table_station *a = batten_offset_table_station(given, k),
                                   *b = batten_offset_table_station(faired, k);
        CHECK_TEXT(a->name, b->name);
        CHECK(a->x == b->x && a->point_count == b->point_count);
        for (int i = 0; i < a->point_count; i++) {
            const batten_table_point *p = a->points + i, *q = b->points + i;
            CHECK(p->x == q->x && p->line == q->line);
            CHECK(hypot(q->y - p->y, q->z - p->z) <= 0.125);
        }
    }
    CHECK(batten_design_result(design, "hull")->loft->faired_error < 1e-12);
    batten_design_free(design);
}

TEST(what_was_not_lofted_has_no_faired_table)
{
    batten_design *design = NULL;
    open_boat(&design);
    CHECK_STATUS(batten_design_evaluate(design, "none", NULL, NULL), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("'table' is not lofted, and has no faired table");
    batten_design_free(design);
}
