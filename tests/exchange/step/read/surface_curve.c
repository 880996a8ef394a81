/* Curves on surfaces in complex instances, where the name stands in REPRESENTATION_ITEM. */
#include "exchange/reading.h"
#include "exchange/step/reading.h"
#include "support/drilled_box.h"

/* What "#7=WORD('',arguments);" becomes. */
static const struct {
    const char *simple, *before, *after;
} rewritings[] = {
    {"=PCURVE('',",
     "=(BOUNDED_CURVE()BOUNDED_PCURVE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()PCURVE(",
     ")REPRESENTATION_ITEM(''));"},
    {"=SURFACE_CURVE('',",
     "=(BOUNDED_CURVE()BOUNDED_SURFACE_CURVE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()"
     "REPRESENTATION_ITEM('')SURFACE_CURVE(",
     "));"},
    {"=SEAM_CURVE('',",
     "=(CURVE()GEOMETRIC_REPRESENTATION_ITEM()REPRESENTATION_ITEM('')SEAM_CURVE()SURFACE_CURVE(",
     "));"},
};

static const char *as_complex(const char *text)
{
    char *made = test_array(4 * strlen(text) + 1, 1), *to = made;
    while (*text) {
        int k = 0;
        while (k < COUNT(rewritings) &&
               strncmp(text, rewritings[k].simple, strlen(rewritings[k].simple)) != 0)
            k++;
        if (k == COUNT(rewritings)) {
            *to++ = *text++;
            continue;
        }
        text += strlen(rewritings[k].simple);
        const char *end = strstr(text, ");");
        to += sprintf(to, "%s%.*s%s", rewritings[k].before, (int)(end - text), text,
                      rewritings[k].after);
        text = end + 2;
    }
    return made;
}

/* How many uses of its edges have a curve in the parameters. */
static int count_parameters(const batten_model *model)
{
    const batten_body_parts *parts = batten_body_view(batten_model_object(model, 0)->body);
    int count = 0;
    for (int i = 0; i < parts->use_count; i++)
        count += parts->uses[i].parameters != NULL;
    return count;
}

TEST(curves_in_parameters_are_read_in_complex_instances_as_in_simple_ones)
{
    batten_body *body = NULL;
    batten_model *model = NULL, *back[2] = {NULL, NULL};
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "block", .kind = BATTEN_OBJECT_BODY, .body = body}));
    const char *simple = step_text(model, NULL), *complex = as_complex(simple);
    CHECK(strstr(complex, "')SURFACE_CURVE(") && strstr(complex, "()PCURVE("));
    back[0] = read_noting(simple, BATTEN_FORMAT_STEP, "");
    back[1] = read_noting(complex, BATTEN_FORMAT_STEP, "");
    CHECK(count_parameters(back[0]) > 0);
    CHECK_INT(count_parameters(back[1]), count_parameters(back[0]));
    CHECK_TEXT(step_text(back[1], NULL), step_text(back[0], NULL));
    for (int k = 0; k < 2; k++)
        batten_model_unref(back[k]);
    batten_model_unref(model);
    batten_body_unref(body);
}
