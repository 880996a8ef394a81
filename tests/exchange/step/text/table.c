/* Lines of a text, and instances found by number. */
#include "exchange/step/text/table.h"

#include "exchange/step/parsing.h"

/* Lines of 0 to 40 bytes, some 4,000 in all, with one kind of end. */
static size_t make_lines(const char *end, char *text)
{
    size_t size = 0;
    for (int i = 0; i < 200; i++) {
        for (int k = 0; k < i * 7 % 41; k++)
            text[size++] = 'x';
        memcpy(text + size, end, strlen(end));
        size += strlen(end);
    }
    return size;
}

TEST(every_byte_is_in_its_line_whatever_ends_the_lines)
{
    static const char *const ends[] = {"\n", "\r\n", "\r"};
    for (int e = 0; e < COUNT(ends); e++) {
        char *text = test_array(16000, 1);
        batten_read_options options = batten_read_defaults();
        bat_input input;
        CHECK_OK(
            bat_input_begin(text, make_lines(ends[e], text), &options, NULL, NULL, &input));
        bat_step_file file = {.input = &input, .lines = {.size = sizeof(uint32_t)}};
        CHECK_OK(bat_step_table_lines(&file));
        const char counted = e == 2 ? '\r' : '\n';
        int line = 1;
        for (size_t at = 0; at < input.size; at++) {
            CHECK_INT(bat_step_line(&file, at), line);
            line += text[at] == counted;
        }
        CHECK_INT(line, 201);
        CHECK_INT(bat_step_line(&file, 1 << 20), 0);
        bat_release(file.lines.items);
    }
}

/* Numbers in order and not, close together, far apart, and each given once or again. */
static const struct {
    int count;
    unsigned long long ids[6];
} orders[] = {
    {1, {7}},
    {3, {7, 8, 9}},
    {3, {9, 8, 7}},
    {5, {3, 1, 5, 2, 4}},
    {4, {7, 9, 12, 23}}, /* within four times their count */
    {4, {7, 9, 12, 24}}, /* and beyond */
    {6, {1000, 1, 50, 7, 20000000000, 3}},
};

TEST(every_instance_is_found_and_no_other)
{
    for (int i = 0; i < COUNT(orders); i++) {
        char data[300] = "";
        step_text_file t = {.notes = NULL};
        for (int k = 0; k < orders[i].count; k++)
            snprintf(data + strlen(data), 40, "#%llu=X(%d);\n", orders[i].ids[k], k);
        CHECK_OK(step_begin(&t, step_whole(data)));
        CHECK_INT(t.file.instances.count, orders[i].count);
        for (int k = 0; k < orders[i].count; k++) {
            int value = -1;
            const bat_step_instance *found = step_find(&t, orders[i].ids[k]);
            CHECK(found->id == orders[i].ids[k]);
            CHECK_INT(bat_step_line(&t.file, found->at), 8 + k);
            CHECK_OK(bat_step_get_integer(&t.file, bat_step_first(&t.file, found), 0, &value));
            CHECK_INT(value, k);
        }
        for (unsigned long long id = 0; id < 60; id++) {
            bool is_there = false;
            for (int k = 0; k < orders[i].count; k++)
                is_there |= orders[i].ids[k] == id;
            CHECK((bat_step_find(&t.file, id) != NULL) == is_there);
        }
        CHECK(!bat_step_find(&t.file, UINT64_MAX));
        step_end(&t);
    }
}

TEST(of_instances_with_one_number_the_first_in_the_file_is_used)
{
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(
        &t, step_whole("#5=X(1);\n#2=X(2);\n#5=X(3);\n#2=X(4);\n#5=X(5);\n#9=X(6);\n")));
    CHECK_INT(t.file.instances.count, 3);
    static const struct {
        unsigned id;
        int value;
    } kept[] = {{2, 2}, {5, 1}, {9, 6}};
    for (int k = 0; k < 3; k++) {
        int value = 0;
        const bat_step_record *record = bat_step_first(&t.file, step_find(&t, kept[k].id));
        CHECK_OK(bat_step_get_integer(&t.file, record, 0, &value));
        CHECK_INT(value, kept[k].value);
    }
    CHECK_INT(t.input.left_out, 3);
    if (batten_notes_dropped(t.notes) == 0) {
        static const struct {
            int line;
            const char *entity, *text;
        } notes[] = {{11, "#2", "the number is given again; line 9 is used, this is left out"},
                     {10, "#5", "the number is given again; line 8 is used, this is left out"},
                     {12, "#5", "the number is given again; line 8 is used, this is left out"}};
        CHECK_INT(batten_notes_count(t.notes), 3);
        for (int k = 0; k < 3; k++) {
            CHECK_INT(batten_notes_at(t.notes, k)->line, notes[k].line);
            CHECK_TEXT(batten_notes_at(t.notes, k)->entity, notes[k].entity);
            CHECK_TEXT(batten_notes_at(t.notes, k)->text, notes[k].text);
        }
    }
    step_end(&t);
}
