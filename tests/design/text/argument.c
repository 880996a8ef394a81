#include "design/text/document.h"

#include "support/test.h"

static batten_status parse(const char *source, bat_document *out)
{
    const batten_design_options options = batten_design_defaults();
    const batten_status status =
        bat_document_parse(source, strlen(source), &options, &bat_all_features, NULL, out);
    if (status != BATTEN_OK)
        bat_document_free(out);
    return status;
}

static const bat_argument *argument(const bat_document *d, const char *feature, int index)
{
    const int i = bat_document_feature(d, feature);
    CHECK(i >= 0);
    return &d->features[i].arguments[index];
}

TEST(arguments_have_the_type_of_their_parameter)
{
    bat_document d;
    static const char good[] = "batten: 1\nunits: mm\nfeatures:\n"
                               "  p: {points: [[1 m, 2 in], x]}\n"
                               "  one: {points: -x}\n"
                               "  m: {mirror: one, plane: z, at: 3 cm, keep: no}\n"
                               "  all: {collect: [one, m]}\n"
                               "  r: {rotate: one, by: 90 deg}\n"
                               "outputs:\n  all.xyz: [p, one]\n";
    CHECK_OK(parse(good, &d));
    const bat_argument *points = argument(&d, "p", 0);
    CHECK_INT(points->count, 2);
    CHECK_BITS(points->items[0].number[0], 1000);
    CHECK_NEAR(points->items[0].number[1], 50.8, 1e-13);
    CHECK_BITS(points->items[1].number[0], 1);
    CHECK_INT(argument(&d, "one", 0)->count, 1);
    CHECK_BITS(argument(&d, "one", 0)->items[0].number[0], -1);
    CHECK_INT(argument(&d, "m", 0)->items[0].count, bat_document_feature(&d, "one"));
    CHECK_INT(argument(&d, "m", 1)->items[0].count, 3);
    CHECK_BITS(argument(&d, "m", 2)->items[0].number[0], 30);
    CHECK_INT(argument(&d, "m", 3)->count, 0);
    CHECK_INT(argument(&d, "m", 4)->items[0].count, 0);
    CHECK_INT(argument(&d, "all", 0)->count, 2);
    CHECK_NEAR(argument(&d, "r", 1)->items[0].number[0], 1.5707963267948966, 1e-15);
    CHECK(argument(&d, "r", 2)->count == 1 && !argument(&d, "r", 2)->given);
    CHECK_INT(d.outputs[0].arguments[0].count, 2);
    bat_document_free(&d);
}

TEST(arguments_of_the_wrong_kind_say_what_is_expected)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{rotate: p, by: 3}",
         "'by' of rotate needs an angle with its unit (30 deg, 0.5 rad); '3' is a number"},
        {"{rotate: p, by: 3 m}", "'3 m' is a length"},
        {"{scale: p, by: 3 m}", "'by' of scale needs a number; '3 m' is a length"},
        {"{move: p, by: up}", "or one of origin x y z -x -y -z, not 'up'"},
        {"{mirror: p, plane: center}",
         "cannot be 'center'; did you mean 'centre'; it is one of: centre x y z"},
        {"{mirror: p, keep: maybe}", "must be yes or no, not 'maybe'"},
        {"{mirror: [p]}", "mirror needs the name of a feature, not a list"},
        {"{mirror: {a: b}}", "not a map"},
        {"{arc: =2 m * 3 m}", "'=2 m * 3 m' is an area"},
        {"{arc: =max(1 m, 2 m)}", "commas in quotes"},
        {"{circle: 1, axis: [1, 2, [3]]}", "list where a length"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        char source[300];
        bat_document d;
        snprintf(source, sizeof source,
                 "batten: 1\nfeatures:\n  p: {points: [0, 0]}\n  a: %s\n", rows[i].feature);
        CHECK_STATUS(parse(source, &d), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(rows[i].says);
    }
}
