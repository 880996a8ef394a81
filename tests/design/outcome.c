/* What a design came to, for tests that compare one design with another. */
#include "design/outcome.h"

#include "design/example_inputs.h"

#include <batten/design.h>
#include <batten/exchange.h>
#include <batten/text.h>
#include <string.h>

static const char *design_path;

void outcome_write_inputs(void)
{
    design_path = test_scratch("extra.yaml");
    write_example_inputs();
}

static double sum_points(int count, const double *points)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += points[i] * cos(i); /* so that order counts */
    return sum;
}

static void see_model(const batten_model *model, batten_text *made)
{
    batten_box box = {{0, 0, 0}, {0, 0, 0}};
    batten_model_box(model, &box);
    batten_text_add(made, " %d", batten_model_count(model));
    batten_text_add(made, " %.17g %.17g %.17g %.17g %.17g %.17g", box.low.x, box.low.y,
                    box.low.z, box.high.x, box.high.y, box.high.z);
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *o = batten_model_object(model, i);
        if (o->point_count > 0)
            batten_text_add(made, " %d %.17g", o->point_count,
                            sum_points(3 * o->point_count, o->points));
        if (o->kind == BATTEN_OBJECT_SURFACE) {
            const int count = batten_surface_point_count(o->surface, BATTEN_U) *
                              batten_surface_point_count(o->surface, BATTEN_V) *
                              batten_surface_dimension(o->surface);
            batten_text_add(made, " %d %.17g", count,
                            sum_points(count, batten_surface_points(o->surface)));
        }
        if (o->kind == BATTEN_OBJECT_CURVE) {
            const int count =
                batten_curve_point_count(o->curve) * batten_curve_dimension(o->curve);
            batten_text_add(made, " %d %.17g", count,
                            sum_points(count, batten_curve_points(o->curve)));
        }
    }
}

outcome outcome_of(const char *text)
{
    outcome out;
    batten_text said = BATTEN_TEXT, made = BATTEN_TEXT;
    size_t length;
    batten_design_options options = batten_design_defaults();
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    options.file_name = design_path;
    CHECK_OK(batten_notes_create(100, &notes));
    batten_status status = batten_design_parse(text, strlen(text), &options, notes, &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, NULL, NULL, notes);
    if (status != BATTEN_OK)
        batten_text_add(&said, "%s\n", batten_message());
    for (int i = 0; design && i < batten_design_result_count(design); i++) {
        const batten_feature_result *r = batten_design_result_at(design, i);
        if (r->value && strcmp(r->name, "odd") != 0)
            see_model(r->value, &made);
    }
    for (int i = 0; design && i < batten_design_output_count(design); i++) {
        char *data = NULL;
        size_t size = 0;
        if (batten_design_output(design, i, NULL, notes, &data, &size) != BATTEN_OK)
            batten_text_add(&said, "%s\n", batten_message());
        unsigned sum = 0;
        for (size_t k = 0; k < size; k++)
            sum = sum * 31 + (unsigned char)data[k];
        batten_text_add(&made, " %zu %u", size, sum);
        batten_release(data);
    }
    for (int i = 0; i < batten_notes_count(notes); i++)
        batten_text_add(&said, "%s\n", batten_notes_at(notes, i)->text);
    batten_text_add(&said, ".");
    batten_text_add(&made, ".");
    CHECK_OK(batten_text_take(&said, &out.said, &length));
    CHECK_OK(batten_text_take(&made, &out.made, &length));
    batten_text_free(&said);
    batten_text_free(&made);
    batten_design_free(design);
    batten_notes_free(notes);
    return out;
}

void outcome_release(outcome *o)
{
    batten_release(o->said);
    batten_release(o->made);
}
