#include "design/evaluate.h"
#include "design/expect.h"

#include <batten/invariants.h>
#include <batten/text.h>

/* Spans of curves and what is on them: as text for curves whose places are known in closed form, as JSON with the
 * figures of the calls behind it. */

static const char curves[] =
    "  ducks: {points: [[0, 0], [1, 1], [3, -1], [4, 0]]}\n"
    "  wave: {bezier: ducks}\n"
    "  loops: {points: [[0, 0], [3, 3], [-2, 3], [1, 0]]}\n"
    "  loop: {bezier: loops}\n"
    "  cusps: {points: [[0, 0], [1, 1], [0, 1], [1, 0]]}\n"
    "  cusp: {bezier: cusps}\n"
    "  vee: {points: [[-1, 1], [0, -1], [1, 1]]}\n"
    "  bow: {bezier: vee}\n"
    "  head: {part: wave, from: 0, to: 0.3}\n"
    "  tail: {part: wave, from: 0.7, to: 1}\n"
    "  q: {points: [[0, 0], [1, 2], [2, 2], [3, -1], [4, 0]]}\n"
    "  quart: {bezier: q}\n"
    "  bows: {interpolate: q, degree: 2}\n"
    "  square: {polyline: [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]}\n"
    "  ring: {circle: 2}\n"
    "  high: {elevate: loop, by: 9}\n"
    "  back: {points: [[0, 0], [1, 1], [1.3333333333333333, 1.6666666666666667], [1, 1], [0, 0]]}\n"
    "  there: {bezier: back}\n"
    "  rise: {points: [[0, 0, 0], [1, 2, 1], [2, 2, 3], [3, -1, 1], [4, 0, 0]]}\n"
    "  space: {bezier: rise}\n"
    "  even: {points: [[0, 0], [1, 1], [2, 2], [3, 3], [4, 4]]}\n"
    "  line: {bezier: even}\n"
    "  five: {points: [[0, 0], [6, 4], [-3, 6], [5, 6], [-4, 4], [2, 0]]}\n"
    "  quint: {bezier: five}\n";

/* The loop crosses itself at (1 - sqrt 3 / 2) / 2 and (1 + sqrt 3 / 2) / 2. */
static const expect_row texts[] = {
    {"c.txt: {classify: wave}", BATTEN_OK,
     "wave: 1 span, 1 one inflection\n  span 1: one inflection, margin 0.5|; inflection at 0.5\n"},
    {"c.txt: {classify: [head, tail]}", BATTEN_OK,
     "head: 1 span, 1 plain\n|tail: 1 span, 1 plain\n|!inflection at"},
    {"c.txt: {classify: ducks}", BATTEN_BAD_ARGUMENT, "'ducks'"},
    {"c.json: {classify: head}", BATTEN_OK, "\"kind\": \"inflection\", \"inside\": false"},
    {"c.json: {classify: tail}", BATTEN_OK, "\"kind\": \"inflection\", \"inside\": false"},
    {"c.txt: {classify: loop}", BATTEN_OK,
     "loop: 1 span, 1 loop\n  span 1: a loop, margin |, lambda 6, mu 6 (loop); crosses "
     "itself at 0.0669873 and 0.933013\n"},
    {"c.txt: {classify: cusp}", BATTEN_OK,
     "cusp: 1 span, 1 cusp\n  span 1: a cusp, margin 0, lambda 2, mu 2 (cusp); cusp at 0.5\n"},
    {"c.txt: {classify: bows}", BATTEN_OK,
     "bows: 3 spans, 3 plain\n  span 1: no inflection, cusp or loop, margin 0.25, lambda "
     "0.666667, mu 0.666667 (regular)\n  span 2: |\n  span 3: "},
    {"c.txt: {classify: square}", BATTEN_OK,
     "square: 4 spans, 4 |\n  span 1: a straight line, margin |\n  span 4: a straight line|!lambda"},
    {"c.txt: {classify: quart}", BATTEN_OK,
     "quart: 1 span, 1 inflection\n  span 1: degree 4, plane, 1 inflection, margin 0.5; on the "
     "whole curve 2 inflections; inflection at 0.640388\n"},
    {"c.txt: {classify: high}", BATTEN_OK,
     "span 1: degree 12, plane, 1 crossing, |; crossings were searched for and are perhaps not "
     "all, isolated points were not counted; crosses itself at 0.0669873 and 0.933013\n"},
    {"c.txt: {classify: there}", BATTEN_OK,
     "there: 1 span, 1 cusp\n  span 1: degree 4, plane, 1 cusp, margin 0; on the whole curve 1 "
     "cusp; every point is passed more than once; cusp at 0.5\n|!searched"},
    {"c.txt: {classify: space}", BATTEN_OK,
     "space: 1 span\n  span 1: degree 4, in space, margin |!;|!whole"},
    {"c.txt: {classify: line}", BATTEN_OK,
     "line: 1 span\n  span 1: degree 1, a line, margin 0\n"},
    {"c.txt: {classify: quint}", BATTEN_OK,
     "quint: 1 span, 1 crossing\n|; on the whole curve 1 crossing, 1 isolated point; a quintic with "
     "two finite double points: a node and an isolated point; crosses itself at |!isolated point at"},
    {"c.txt: {classify: [bow, loop]}", BATTEN_OK, "bow: 1 span, 1 plain\n|\nloop: 1 span"},
    {"c.txt: {classify: ring}", BATTEN_UNSUPPORTED, "ring: "},
    {"c.json: {classify: [bow, loop]}", BATTEN_OK,
     "{\n  \"curves\": [\n    {\"name\": \"bow\", \"spans\": [\n      {\"segment\": |}]},\n    "
     "{\"name\": \"loop\", \"spans\": [|}]}\n  ]\n}\n"},
    {"c.json: {classify: bows}", BATTEN_OK, "},\n      {\"segment\": \"plain\""},
    {"c.json: {classify: high}", BATTEN_OK, "\"complete\": false|!\"complex\""},
};

TEST(spans_are_called_by_what_is_on_them_with_its_places)
{
    EXPECT_OUTPUTS(curves, texts);
}

/* ---- figures ---- */

static char *classify_as_json(const char *name, batten_design **out)
{
    char text[2500], *data = NULL;
    size_t size;
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\nfeatures:\n%soutputs:\n  c.json: {classify: %s}\n", curves,
             name);
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, out));
    CHECK_OK(batten_design_output(*out, 0, NULL, NULL, &data, &size));
    return data;
}

static const batten_curve *curve_of(const batten_design *design, const char *name)
{
    return batten_model_object(batten_design_result(design, name)->value, 0)->curve;
}

/* The figures stand in this order; `at` moves behind each. */
static void check_next(const char **at, const char *name, double value)
{
    char number[BATTEN_NUMBER_SIZE] = "null", wanted[120];
    if (isfinite(value))
        batten_number_write(value, number);
    snprintf(wanted, sizeof wanted, "\"%s\": %s", name, number);
    CHECK_CONTAINS(*at, wanted);
    *at = strstr(*at, wanted) + strlen(wanted);
    CHECK(**at == ',' || **at == '}');
}

static void check_word(const char **at, const char *name, const char *value)
{
    char wanted[120];
    snprintf(wanted, sizeof wanted, "\"%s\": %s", name, value);
    CHECK_CONTAINS(*at, wanted);
    *at = strstr(*at, wanted) + strlen(wanted);
}

static void check_special(const char **at, const char *kind, bool inside, double t, double s)
{
    char quoted[40];
    snprintf(quoted, sizeof quoted, "\"%s\"", kind);
    check_word(at, "kind", quoted);
    check_word(at, "inside", inside ? "true" : "false");
    check_next(at, "multiplicity", 1);
    check_next(at, "t", t);
    check_next(at, "s", s);
}

static void check_cubic(const char **at, const batten_cubic *c)
{
    check_next(at, "margin", c->margin);
    check_next(at, "whole_margin", c->whole_margin);
    check_next(at, "flatness", c->flatness);
    check_next(at, "p", c->p);
    check_next(at, "q", c->q);
    check_next(at, "r", c->r);
    check_next(at, "invariant", c->invariant);
    check_next(at, "cusp", c->cusp);
    check_next(at, "lambda", c->lambda);
    check_next(at, "mu", c->mu);
    for (int k = 0; k < c->inflection_count; k++)
        check_special(at, "inflection",
                      c->inflections[k] > c->from && c->inflections[k] < c->to,
                      c->inflections[k], NAN);
    if (isfinite(c->cusp))
        check_special(at, "cusp", c->segment == BATTEN_CUBIC_CUSP, c->cusp, NAN);
    if (isfinite(c->crossing[0]))
        check_special(at, "crossing", c->segment == BATTEN_CUBIC_LOOP, c->crossing[0],
                      c->crossing[1]);
}

TEST(all_figures_of_a_cubic_are_in_its_json)
{
    static const char *const names[] = {"wave", "loop", "cusp", "bows"};
    for (int i = 0; i < COUNT(names); i++) {
        batten_design *design = NULL;
        batten_cubics spans = {0, NULL};
        char *json = classify_as_json(names[i], &design);
        CHECK_OK(batten_curve_classify(curve_of(design, names[i]), 1e-9, &spans));
        const char *at = json;
        for (int k = 0; k < spans.count; k++)
            check_cubic(&at, &spans.at[k]);
        CHECK(strstr(at, "\"segment\"") == NULL);
        batten_cubics_release(&spans);
        batten_release(json);
        batten_design_free(design);
    }
}

static void check_census(const char **at, const batten_census *c)
{
    check_next(at, "degree", c->degree);
    check_next(at, "dimension", c->flat_dimension);
    check_word(at, "complete", c->is_complete ? "true" : "false");
    check_word(at, "repeated", c->is_repeated ? "true" : "false");
    check_next(at, "margin", c->margin);
    check_next(at, "flatness", c->flatness);
    for (int k = 0; k < BATTEN_SPECIAL_COUNT; k++)
        check_next(at, batten_special_name((batten_special_kind)k, true), c->segment[k]);
    for (int k = 0; k < BATTEN_SPECIAL_COUNT; k++)
        check_next(at, batten_special_name((batten_special_kind)k, true), c->whole[k]);
    if (c->is_complete) {
        check_next(at, "complex", c->complex_count);
        check_next(at, "infinite", c->infinite_count);
    }
    for (int k = 0; k < c->count; k++)
        check_special(at, batten_special_name(c->specials[k].kind, false),
                      c->specials[k].inside, c->specials[k].t, c->specials[k].s);
}

static void check_form(const char **at, const batten_canonical *form)
{
    check_next(at, "shift", form->has_shift ? form->shift : (double)NAN);
    check_next(at, "radius", form->radius);
    for (int i = 0; i < form->count; i++) {
        check_next(at, "row", form->at[i].row + 1);
        check_next(at, "power", form->at[i].power);
        check_next(at, "weight", form->at[i].weight);
        check_next(at, "value", form->at[i].value);
        check_next(at, "absolute", form->at[i].absolute);
    }
}

TEST(all_figures_of_a_census_and_its_canonical_form_are_in_its_json)
{
    static const char *const names[] = {"quart", "quint", "there", "space"};
    for (int i = 0; i < COUNT(names); i++) {
        batten_design *design = NULL;
        batten_censuses spans = {0, NULL};
        batten_canonicals forms = {0, NULL};
        char *json = classify_as_json(names[i], &design);
        CHECK_OK(batten_curve_census(curve_of(design, names[i]), 1e-9, &spans));
        CHECK_OK(batten_curve_canonical_forms(curve_of(design, names[i]), 1e-10, &forms));
        const char *at = json;
        check_census(&at, spans.at);
        check_form(&at, forms.at);
        batten_canonicals_release(&forms);
        batten_censuses_release(&spans);
        batten_release(json);
        batten_design_free(design);
    }
}
