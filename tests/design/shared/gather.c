/* No input is dropped in silence: to every list of inputs in the examples of the manual an object is added that
 * was not asked for, and it is used, refused or remarked upon. */
#include "design/expect.h"
#include "support/bodies.h"

#include <batten/exchange.h>
#include <batten/text.h>
#include <string.h>

static const char *const extras[] = {
    "{points: [[0.31, 0.22, 0.13], [0.7, 0.1, 0.4], [0.2, 0.9, 0.3]]}",
    "{sphere: 37 cm, at: [0.2, 0.1, 9]}",
    "{box: [0.3, 0.2, 0.1], at: [0.1, 0.2, 9]}",
    "{read: offsets.csv}",
    "{line: [[0.1, 0.2, 9], [0.7, 0.3, 9.5]]}",
};

static const char *design_path;

static void write_inputs(void)
{
    design_path = test_scratch("extra.yaml");
    FILE *file = fopen(test_scratch("offsets.csv"), "w");
    batten_model *model = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){3, 2, 1});
    CHECK(file != NULL);
    fputs("x_m,z_m,half_breadth_m\n", file);
    for (int i = 0; i < 42; i++) {
        const double x = i / 6 - 3.0, z = 0.2 * (i % 6);
        fprintf(file, "%.3f,%.3f,%.6f\n", x, z, (1.2 - x * x / 12) * sqrt(z + 0.04));
    }
    fclose(file);
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "block", .kind = BATTEN_OBJECT_BODY, .body = box}));
    CHECK_OK(batten_write_file(model, test_scratch("block.step"), NULL, NULL));
    batten_model_unref(model);
    batten_body_unref(box);
}

/* All that a design came to: how it ended, what was said, the boxes of all results, all bytes. */
typedef struct {
    char *said, *made;
} outcome;

static void see_model(const batten_model *model, batten_text *made)
{
    batten_box box = {{0, 0, 0}, {0, 0, 0}};
    batten_model_box(model, &box);
    batten_text_add(made, " %d", batten_model_count(model));
    batten_text_add(made, " %.17g %.17g %.17g %.17g %.17g %.17g", box.low.x, box.low.y,
                    box.low.z, box.high.x, box.high.y, box.high.z);
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *o = batten_model_object(model, i);
        if (o->kind == BATTEN_OBJECT_SURFACE)
            for (int k = 0; k < batten_surface_point_count(o->surface, BATTEN_U); k++)
                batten_text_add(made, " %.17g", batten_surface_points(o->surface)[3 * k]);
        if (o->kind == BATTEN_OBJECT_CURVE)
            batten_text_add(made, " %d %.17g", batten_curve_point_count(o->curve),
                            batten_curve_points(o->curve)[0]);
    }
}

static outcome outcome_of(const char *text)
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

enum { MOST = 8000 };

/* The example with "odd" added to the list of this parameter; false when the example has none. */
static bool with_extra(const char *example, const char *parameter, const char *extra,
                       char text[MOST])
{
    char key[80];
    snprintf(key, sizeof key, "{%s: ", parameter);
    const char *at = strstr(example, key);
    if (!at) {
        snprintf(key, sizeof key, ", %s: ", parameter);
        at = strstr(example, key);
    }
    const char *features = strstr(example, "features:\n");
    if (!at || !features)
        return false;
    at += strlen(key);
    const bool is_list = *at == '[';
    const char *end = at + strcspn(at, is_list ? "]" : ",}\n");
    const char *body = features + strlen("features:\n");
    snprintf(text, MOST, "batten: 1\n%.*s  odd: %s\n%.*s%s%.*s, odd]%s", (int)(body - example),
             example, extra, (int)(at - body), body, is_list ? "" : "[", (int)(end - at), at,
             is_list ? end + 1 : end);
    return true;
}

static void release(outcome *o)
{
    batten_release(o->said);
    batten_release(o->made);
}

/* How many kinds of objects are dropped. */
static int try_parameter(const batten_feature *feature, const char *parameter)
{
    char plain[MOST], text[MOST];
    int dropped = 0;
    if (!with_extra(feature->example, parameter, extras[0], text))
        return 0;
    snprintf(plain, sizeof plain, "batten: 1\n%s", feature->example);
    outcome without = outcome_of(plain);
    for (int k = 0; k < COUNT(extras); k++) {
        with_extra(feature->example, parameter, extras[k], text);
        outcome with = outcome_of(text);
        if (strcmp(without.made, with.made) == 0 && strcmp(without.said, with.said) == 0) {
            printf("%s: '%s' drops %s in silence\n%s\n", feature->name, parameter, extras[k],
                   text);
            dropped++;
        }
        release(&with);
    }
    release(&without);
    return dropped;
}

TEST(G0_an_input_is_used_refused_or_remarked_upon)
{
    const int cases = test_cases(1000); /* few when allocations fail */
    int dropped = 0;
    write_inputs();
    for (int i = 0; i < batten_feature_count() && i < cases; i++) {
        const batten_feature *feature = batten_feature_at(i);
        for (int k = 0; k < feature->parameter_count; k++)
            if (feature->parameters[k].kind == BATTEN_VALUE_MODEL &&
                feature->parameters[k].is_list)
                dropped += try_parameter(feature, feature->parameters[k].name);
    }
    CHECK_INT(dropped, 0);
}
