#include "design/text/document.h"

#include "support/test.h"

#include <stdlib.h>

static batten_status parse(const char *source, batten_design **out)
{
    return batten_design_parse(source, strlen(source), NULL, NULL, out);
}

static const char *const styles[] = {
    "batten: 1\nunits: m # metres\nparameters:\n  x: 1 m   # the first\n  'y': 2\nfeatures:\n"
    "  a: {points: [[0, 0], [=x, 0]], columns: 2} # two\n  b:\n    points: [[0, 1], [2, 1]]   "
    "# tail\n"
    "    columns: 1\n\n# end\noutputs:\n  b.csv: {write: b}\n",
    "batten: 1\r\nunits: m\r\nparameters: {x: 1 m, 'y': 2}\r\nfeatures:\r\n"
    "  a: {points: [[0, 0], [=x, 0]], columns: 2}\r\n  b:\r\n    points: [[0, 1], [2, 1]]\r\n"
    "    columns: 1\r\noutputs: {b.csv: {write: b}}",
    "\xEF\xBB\xBF"
    "{batten: 1, units: \"m\", parameters: {x: 1 m, 'y': 2}, features: {a: {points: [[0, 0], "
    "[=x, 0]], columns: 2},"
    " b: {points: [[0, 1],\n [2, 1]], columns: 1}}, outputs: {b.csv: {write: b}}}\n",
};

TEST(loaded_and_saved_is_the_same_bytes)
{
    for (int i = 0; i < COUNT(styles); i++) {
        batten_design *design = NULL;
        CHECK_OK(parse(styles[i], &design));
        CHECK_TEXT(batten_design_text(design, NULL), styles[i]);
        batten_design_free(design);
    }
}

TEST(a_value_set_and_set_back_leaves_the_same_bytes)
{
    static const struct {
        const char *path, *value, *back;
    } rows[] = {
        {"parameters.x", "3.4 m", "1 m"},
        {"parameters.y", "=x / 2 m", "2"},
        {"features.a.columns", "1", "2"},
        {"features.b.columns", "=2", "1"},
        {"features.b.points", "[[5, 5], [6, 6]]", NULL},
        {"outputs.b.csv.write", "a", "b"},
        {"parameters.y", "=max(1, 2)", "2"},
    };
    for (int s = 0; s < COUNT(styles); s++)
        for (int i = 0; i < COUNT(rows); i++) {
            batten_design *design = NULL;
            CHECK_OK(parse(styles[s], &design));
            CHECK_OK(batten_design_set(design, rows[i].path, rows[i].value, NULL));
            CHECK(strcmp(batten_design_text(design, NULL), styles[s]) != 0);
            CHECK(strstr(batten_design_text(design, NULL), rows[i].value) != NULL);
            if (rows[i].back) {
                CHECK_OK(batten_design_set(design, rows[i].path, rows[i].back, NULL));
                CHECK_TEXT(batten_design_text(design, NULL), styles[s]);
            }
            batten_design_free(design);
        }
}

TEST(only_the_bytes_of_the_value_change)
{
    batten_design *design = NULL;
    CHECK_OK(parse(styles[0], &design));
    CHECK_OK(batten_design_set(design, "parameters.x", "3.4 m", NULL));
    const char *now = batten_design_text(design, NULL);
    const size_t begin = (size_t)(strstr(styles[0], "1 m   #") - styles[0]);
    CHECK(memcmp(now, styles[0], begin) == 0);
    CHECK(memcmp(now + begin, "3.4 m", 5) == 0);
    CHECK_TEXT(now + begin + 5, styles[0] + begin + 3);
    batten_design_free(design);
}

TEST(a_new_key_is_appended_in_the_style_of_its_map)
{
    static const struct {
        const char *before, *path, *value, *after;
    } rows[] = {
        {"batten: 1\nfeatures:\n  a: {points: [0, 0]} # c\n", "features.a.columns", "1",
         "batten: 1\nfeatures:\n  a: {points: [0, 0], columns: 1} # c\n"},
        {"batten: 1\nfeatures:\n  a:\n    points: [0, 0]   # c\n\n", "features.a.columns", "1",
         "batten: 1\nfeatures:\n  a:\n    points: [0, 0]   # c\n    columns: 1\n\n"},
        {"batten: 1\r\nfeatures:\r\n  a:\r\n    points: [0, 0]", "features.a.columns", "1",
         "batten: 1\r\nfeatures:\r\n  a:\r\n    points: [0, 0]\r\n    columns: 1"},
        {"batten: 1", "units", "mm", "batten: 1\nunits: mm"},
        {"{batten: 1}\n", "units", "mm", "{batten: 1, units: mm}\n"},
        {"batten: 1\nparameters: {}\n", "parameters.x", "3 m",
         "batten: 1\nparameters: {x: 3 m}\n"},
        {"batten: 1\nfeatures:\n  a: {points: [0, 0], }\n", "features.a.columns", "1",
         "batten: 1\nfeatures:\n  a: {points: [0, 0], columns: 1, }\n"},
        {"batten: 1\nfeatures:\n  a:\n    points:\n      - [0, 0]\n      - [1, 0]\n",
         "features.b", "{collect: a}",
         "batten: 1\nfeatures:\n  a:\n    points:\n      - [0, 0]\n      - [1, 0]\n  b: "
         "{collect: a}\n"},
        {"batten: 1\nparameters: {x: 1}\n", "parameters.y", "=max(x, 2)",
         "batten: 1\nparameters: {x: 1, y: '=max(x, 2)'}\n"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(parse(rows[i].before, &design));
        CHECK_OK(batten_design_set(design, rows[i].path, rows[i].value, NULL));
        CHECK_TEXT(batten_design_text(design, NULL), rows[i].after);
        batten_design_free(design);
    }
}

TEST(what_would_change_more_than_the_value_is_refused)
{
    static const struct {
        const char *path, *value;
    } rows[] = {
        {"parameters.x", ""},
        {"parameters.x", "1\ny: 2"},
        {"parameters.x", "1 # no"},
        {"features.a.columns", "1}"},
        {"features.a.columns", "2, x: 3"},
        {"parameters.x", "[1"},
        {"parameters.x", "&a 1"},
        {"", "1"},
        {"parameters.x", "'open"},
        {"batten.x", "1"},
        {"other.x", "1"},
        {"features.b", "{collect: a}"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(parse(styles[0], &design));
        batten_status status = batten_design_set(design, rows[i].path, rows[i].value, NULL);
        CHECK(status != BATTEN_OK);
        CHECK_TEXT(batten_design_text(design, NULL), styles[0]);
        batten_design_free(design);
    }
}

TEST(random_values_change_nothing_else)
{
    test_random random = test_random_begin("edit");
    static const char letters[] = "0123456789.m =+-*/()x\"'#:,[]{}&!\\";
    for (int i = 0; i < test_cases(300); i++) {
        const char *before = styles[i % COUNT(styles)];
        char value[12] = "";
        for (int k = test_random_int(&random, 1, 10); k > 0; k--)
            value[k - 1] = letters[test_random_int(&random, 0, (int)sizeof letters - 2)];
        batten_design *design = NULL;
        CHECK_OK(parse(before, &design));
        if (batten_design_set(design, "parameters.x", value, NULL) == BATTEN_OK) {
            CHECK_OK(batten_design_set(design, "parameters.x", "1 m", NULL));
            CHECK_TEXT(batten_design_text(design, NULL), before);
        }
        batten_design_free(design);
    }
}
