#include "design/text/yaml.h"

#include "support/test.h"

#include <stdlib.h>

static batten_status parse(const char *text, bat_tree *tree, bat_place *place)
{
    const batten_status status = bat_tree_parse(text, strlen(text), 64, tree, place);
    if (status != BATTEN_OK)
        bat_tree_free(tree);
    return status;
}

static const bat_node *at(const bat_tree *tree, int node, const char *key)
{
    const int found = bat_tree_find(tree, node, key);
    CHECK(found >= 0);
    return &tree->nodes[found];
}

TEST(words_know_their_bytes_lines_and_columns)
{
    static const char text[] =
        "a: 1 # \xC3\xA9\r\n\xC3\xA9t\xC3\xA9: {x: 'it''s', no: no}\nlist:\n  - p\n  - q r\n";
    bat_tree tree;
    bat_place place;
    CHECK_OK(parse(text, &tree, &place));
    const bat_node *map = at(&tree, 0, "\xC3\xA9t\xC3\xA9");
    const bat_node *x = at(&tree, (int)(map - tree.nodes), "x");
    CHECK_TEXT(x->word, "it's");
    CHECK(!x->plain && memcmp(text + x->begin, "'it''s'", x->end - x->begin) == 0);
    CHECK_INT(x->line, 2);
    CHECK_INT(x->column, 10);
    CHECK_TEXT(at(&tree, (int)(map - tree.nodes), "no")->word, "no");
    CHECK(map->flow && text[map->begin] == '{' && text[map->end - 1] == '}');
    const bat_node *list = at(&tree, 0, "list");
    CHECK(!list->flow && list->kind == BAT_NODE_LIST && list->count == 2);
    CHECK(memcmp(text + list->end - 3, "q r", 3) == 0);
    CHECK_INT(list->after, tree.count);
    bat_tree_free(&tree);
}

TEST(F4_a_byte_order_mark_is_skipped)
{
    bat_tree tree;
    bat_place place;
    CHECK_OK(parse("\xEF\xBB\xBF"
                   "a: b\n",
                   &tree, &place));
    CHECK_INT((int)at(&tree, 0, "a")->begin, 6);
    CHECK_INT(at(&tree, 0, "a")->column, 4);
    bat_tree_free(&tree);
}

TEST(what_designs_do_not_use_is_refused_by_name)
{
    static const struct {
        const char *text, *says;
        int line, column;
    } rows[] = {
        {"a: &x 1\n", "anchor", 1, 4},
        {"a: 1\nb: *x\n", "alias", 2, 4},
        {"a: !!int 1\n", "tag", 1, 4},
        {"a: !mine {b: c}\n", "tag", 1, 4},
        {"a: &x [b]\n", "anchor", 1, 4},
        {"a: |\n  text\n", "quotes", 1, 4},
        {"a: >\n  text\n", "quotes", 1, 4},
        {"? [a]\n: b\n", "key must be a word", 1, 3},
        {"a: 1\nb: 2\na: 3\n", "second time", 3, 1},
        {"--- {a: b}\n--- {c: d}\n", "second document", 2, 1},
        {"a: [1, 2\nb: 3\n", "", 2, 0},
        {"\ta: 1\n", "", 1, 0},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_tree tree;
        bat_place place = {0, 0};
        CHECK_STATUS(parse(rows[i].text, &tree, &place), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(rows[i].says);
        CHECK_INT(place.line, rows[i].line);
        if (rows[i].column)
            CHECK_INT(place.column, rows[i].column);
    }
}

TEST(F1_an_empty_text_is_refused)
{
    static const char *const texts[] = {"", "\n", "   \n\n", "# only a comment\n",
                                        "\xEF\xBB\xBF"};
    for (int i = 0; i < COUNT(texts); i++) {
        bat_tree tree;
        bat_place place;
        CHECK_STATUS(parse(texts[i], &tree, &place), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE("empty");
    }
}

TEST(F4_other_encodings_and_NUL_are_refused)
{
    static const struct {
        const char *bytes;
        size_t length;
        const char *says;
    } rows[] = {{"\xFF\xFE"
                 "a\0:\0",
                 6, "UTF-16"},
                {"\xFE\xFF\0a\0:", 6, "UTF-16"},
                {"a\0:\0 \0", 6, "UTF-16"},
                {"a: b\nc: \0\n", 10, "NUL"},
                {"a: \"\\0\"\n", 8, "NUL"},
                {"a: \xE9\n", 5, "UTF-8"},
                {"a: \x01\n", 5, "control"}};
    for (int i = 0; i < COUNT(rows); i++) {
        bat_tree tree;
        bat_place place;
        batten_status status = bat_tree_parse(rows[i].bytes, rows[i].length, 64, &tree, &place);
        bat_tree_free(&tree);
        if (test_memory_failed(status, BATTEN_BAD_FORMAT)) {
            status = bat_tree_parse(rows[i].bytes, rows[i].length, 64, &tree, &place);
            bat_tree_free(&tree);
        }
        CHECK_INT(status, BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(rows[i].says);
    }
}

TEST(S4_deep_nesting_is_refused_at_the_limit)
{
    static const char *const opens[] = {"[", "{a: ", "- "};
    for (int i = 0; i < COUNT(opens); i++) {
        const size_t step = strlen(opens[i]), size = 1000000;
        char *text = test_array(size + 1, 1);
        for (size_t k = 0; k + step <= size; k += step)
            memcpy(text + k, opens[i], step);
        bat_tree tree;
        bat_place place;
        CHECK_STATUS(parse(text, &tree, &place), BATTEN_TOO_LARGE);
        CHECK_MESSAGE("limit, 64");
        CHECK_INT(place.line, 1);
    }
}

TEST(F3_line_ends_of_any_kind_give_the_same_words)
{
    static const char *const texts[] = {"a: 1\nb:\n  c: x y\n", "a: 1\r\nb:\r\n  c: x y\r\n",
                                        "a: 1\rb:\r  c: x y\r", "a: 1\r\nb:\n  c: x y"};
    for (int i = 0; i < COUNT(texts); i++) {
        bat_tree tree;
        bat_place place;
        CHECK_OK(parse(texts[i], &tree, &place));
        const bat_node *b = at(&tree, 0, "b");
        const bat_node *c = at(&tree, (int)(b - tree.nodes), "c");
        CHECK_TEXT(c->word, "x y");
        CHECK_INT(c->line, 3);
        CHECK(memcmp(texts[i] + c->begin, "x y", 3) == 0);
        bat_tree_free(&tree);
    }
}

TEST(F2_a_text_cut_anywhere_never_crashes)
{
    static const char text[] =
        "batten: 1\nfeatures:\n  a: {points: [[0, 0], [1, \"2\"]]}\n  b:\n    - x\n";
    for (size_t length = 0; length < sizeof text; length++) {
        bat_tree tree;
        bat_place place;
        bat_tree_parse(text, length, 64, &tree, &place);
        for (int i = 0; i < tree.count; i++)
            CHECK(tree.nodes[i].end <= length);
        bat_tree_free(&tree);
    }
}
