#include "design/example_inputs.h"
#include "design/feature.h"

#include "support/prose.h"
#include "support/test.h"

#include <batten/exchange.h>
#include <stdlib.h>

static char *whole_design(const char *example)
{
    const size_t size = strlen(example) + 20;
    char *text = test_array(size, 1);
    snprintf(text, size, "batten: 1\n%s", example);
    return text;
}

static batten_status open_example(const char *text, batten_design **out)
{
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("example.yaml");
    write_example_inputs();
    return batten_design_parse(text, strlen(text), &options, NULL, out);
}

static batten_status make_output(batten_design *design, int i)
{
    char *data = NULL;
    size_t size = 0;
    const batten_status status = batten_design_output(design, i, NULL, NULL, &data, &size);
    CHECK(status != BATTEN_OK || size > 0);
    batten_release(data);
    return status;
}

/* Does the design use the operation? */
static bool uses(const batten_design *design, const batten_feature *feature)
{
    bool used = feature->is_output && batten_design_output_count(design) > 0;
    for (int i = 0; i < batten_design_result_count(design); i++)
        used |= strcmp(batten_design_result_at(design, i)->operation, feature->name) == 0;
    return used;
}

static void run_example(const batten_feature *feature)
{
    batten_design *design = NULL;
    const char *text = whole_design(feature->example);
    CHECK_OK(open_example(text, &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    CHECK(uses(design, feature));
    for (int k = 0; k < batten_design_output_count(design); k++)
        CHECK_OK(make_output(design, k));
    batten_design_free(design);
}

/* In several tests of eight, so that each is short when allocations fail one after another. */
#define EXAMPLES(n)                                                               \
    TEST(the_examples_of_the_manual_work_##n)                                     \
    {                                                                             \
        for (int i = 8 * (n); i < 8 * (n) + 8 && i < batten_feature_count(); i++) \
            run_example(batten_feature_at(i));                                    \
    }
EXAMPLES(0)
EXAMPLES(1)
EXAMPLES(2)
EXAMPLES(3)
EXAMPLES(4)
EXAMPLES(5)
EXAMPLES(6)
EXAMPLES(7)
EXAMPLES(8)
EXAMPLES(9)
EXAMPLES(10)
EXAMPLES(11)
EXAMPLES(12)
EXAMPLES(13)
EXAMPLES(14)
EXAMPLES(15)
EXAMPLES(16)
EXAMPLES(17)
EXAMPLES(18)
EXAMPLES(19)
EXAMPLES(20)
EXAMPLES(21)
EXAMPLES(22)
EXAMPLES(23)

TEST(no_example_of_the_manual_is_left_out)
{
    CHECK(batten_feature_count() <= 8 * 24);
}

TEST(every_feature_is_described_whole)
{
    for (int i = 0; i < batten_feature_count(); i++) {
        const batten_feature *f = batten_feature_at(i);
        CHECK(f->name && *f->name && f->summary && *f->summary && f->manual && *f->manual);
        CHECK(f->example && *f->example && f->source && f->function && *f->function);
        CHECK(f->parameter_count > 0);
        for (int k = 0; k < i; k++)
            CHECK(strcmp(batten_feature_at(k)->summary, f->summary) != 0);
        CHECK_TEXT(f->parameters[0].name, f->name);
        CHECK(f->parameters[0].required);
        CHECK(batten_feature_find(f->name) == f);
        for (int k = 0; k < f->parameter_count; k++) {
            const batten_parameter *p = &f->parameters[k];
            CHECK(p->summary && *p->summary && strlen(p->summary) < 100);
            CHECK((p->kind == BATTEN_VALUE_WORD) == (p->words != NULL));
            CHECK(!p->required || !p->standard);
            for (int j = 0; j < k; j++)
                CHECK(strcmp(p->name, f->parameters[j].name) != 0);
        }
    }
    CHECK(batten_feature_find("nothing") == NULL);
}

static char *read_whole(const char *path)
{
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL);
    CHECK(fseek(file, 0, SEEK_END) == 0);
    const long size = ftell(file);
    CHECK(size > 0);
    rewind(file);
    char *text = test_array((size_t)size + 1, 1);
    CHECK(fread(text, 1, (size_t)size, file) == (size_t)size);
    text[size] = '\0';
    fclose(file);
    return text;
}

static int times_in(const char *text, const char *word)
{
    int times = 0;
    for (const char *at = text; (at = strstr(at, word)); at++)
        times++;
    return times;
}

/* All keys in square brackets of one line of sources. */
static void check_keys(const char *bibliography, const char *feature, const char *source)
{
    for (const char *at = source; (at = strchr(at, '[')); at++) {
        char entry[60];
        snprintf(entry, sizeof entry, "{%.*s,", (int)strcspn(at + 1, " ]"), at + 1);
        if (times_in(bibliography, entry) != 1)
            printf("%s: %s\n", feature, entry);
        CHECK_INT(times_in(bibliography, entry), 1);
    }
}

TEST(every_source_is_in_the_bibliography_once)
{
    const char *bibliography = read_whole(test_source("docs/bibliography.bib"));
    CHECK_INT(times_in(bibliography, "{"), times_in(bibliography, "}"));
    CHECK_INT(times_in(bibliography, "\n@"), times_in(bibliography, "}\n\n@"));
    for (int i = 0; i < batten_feature_count(); i++) {
        const batten_feature *f = batten_feature_at(i);
        if (f->source)
            check_keys(bibliography, f->name, f->source);
    }
}

/* The groups whose operations follow from a formula. */
static bool has_methods(const char *group)
{
    static const char *const begin[] = {"Curves ", "Arcs ", "Exact ", "Fairing", "Surfaces "};
    for (size_t i = 0; i < sizeof begin / sizeof begin[0]; i++)
        if (strncmp(group, begin[i], strlen(begin[i])) == 0)
            return true;
    return false;
}

TEST(every_curve_and_surface_method_has_its_formula_and_what_it_promises)
{
    for (int i = 0; i < batten_feature_count(); i++) {
        const batten_feature *f = batten_feature_at(i);
        const bool wanted = has_methods(batten_feature_group(i));
        if (wanted && (!f->formula || !f->promise))
            printf("%s has no formula, or no promise\n", f->name);
        CHECK(!wanted || (f->formula && f->promise));
        CHECK(!f->formula == !f->promise);
        CHECK(!f->formula || strncmp(f->formula, "    ", 4) == 0);
        CHECK(!f->promise || f->promise[strlen(f->promise) - 1] == '.');
    }
}

TEST(every_operation_is_known_by_other_names)
{
    for (int i = 0; i < batten_feature_count(); i++) {
        const batten_feature *f = batten_feature_at(i);
        if (!f->also || !*f->also)
            printf("%s has no other names\n", f->name);
        CHECK(f->also && *f->also);
    }
}

static bool has_feature(const batten_source_place *place)
{
    for (int i = 0; i < batten_feature_count(); i++)
        if (batten_feature_has_place(batten_feature_at(i), place))
            return true;
    return false;
}

TEST(every_place_of_the_literature_has_a_feature_or_a_reason)
{
    CHECK(batten_source_place_count() > 70);
    for (int i = 0; i < batten_source_place_count(); i++) {
        const batten_source_place *place = batten_source_place_at(i);
        CHECK(batten_source_find(place->key) != NULL);
        if (has_feature(place) == (place->without != NULL))
            printf("%s %s\n", place->key, place->place);
        CHECK(has_feature(place) == (place->without == NULL));
    }
    CHECK(batten_source_find("Nobody00") == NULL);
}

static bool stands_on(const char *name, const char *key, const char *place)
{
    return batten_feature_has_place(batten_feature_find(name),
                                    &(batten_source_place){key, place, "", NULL});
}

TEST(a_range_of_formulas_holds_those_within_it_and_no_others)
{
    CHECK(stands_on("interpolate-grid", "LN12", "formula 12.7.14"));
    CHECK(stands_on("interpolate-grid", "LN12", "formula 12.7.30"));
    CHECK(!stands_on("interpolate-grid", "LN12", "formula 12.7.31"));
    CHECK(!stands_on("interpolate-grid", "LN12", "formula 12.8.14"));
    CHECK(stands_on("interpolate", "SL", "section III.6"));
    CHECK(!stands_on("interpolate", "SL", "section III.7"));
    CHECK(!stands_on("interpolate", "Utah74", "section III.6"));
}

TEST(a_misspelt_operation_has_a_nearest_name)
{
    CHECK_TEXT(batten_feature_nearest("pointz"), "points");
    CHECK_TEXT(batten_feature_nearest("colect"), "collect");
    CHECK(batten_feature_nearest("qqqqqq") == NULL);
}

TEST(no_help_text_has_an_orphan_line)
{
    for (int i = 0; i < batten_feature_count(); i++) {
        const char *orphan = test_orphan_line(batten_feature_at(i)->manual);
        CHECK_TEXT(orphan ? orphan : "", "");
    }
}
