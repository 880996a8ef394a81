/* The layout of records: columns, letters, numbers, entries of the directory. */
#include "exchange/shapes.h"

#include <stdlib.h>

/* A field of a record, as a number; blanks before it, and nothing else. */
static long field(const char *record, int column, int width)
{
    char text[32] = "", *end;
    memcpy(text, record + column, (size_t)width);
    CHECK(text[width - 1] != ' ');
    const long value = strtol(text, &end, 10);
    CHECK(*end == '\0');
    return value;
}

/* The records of each section, counted from 1 without a gap, in the order S, G, D, P, T; the last
 * record says how many there are. */
static void check_sections(const char *data, size_t size, long counts[5])
{
    static const char letters[] = "SGDPT";
    int section = 0;
    memset(counts, 0, 5 * sizeof *counts);
    CHECK_INT((long long)(size % 81), 0);
    for (const char *record = data; record < data + size; record += 81) {
        while (section < 4 && record[72] != letters[section])
            section++;
        CHECK_INT(record[72], letters[section]);
        CHECK_INT(record[80], '\n');
        CHECK_INT(field(record, 73, 7), ++counts[section]);
    }
    CHECK_INT(counts[4], 1);
    for (int k = 0; k < 4; k++) {
        CHECK_INT(data[size - 81 + 8 * (size_t)k], letters[k]);
        CHECK_INT(field(data + size - 81 + 8 * k, 1, 7), counts[k]);
    }
}

/* Each entry names the records of its entity, and each of these the entry. */
static void check_entries(const char *directory, const char *records, long count)
{
    long next = 1;
    for (long id = 1; id <= count; id += 2) {
        const char *first = directory + (id - 1) * 81, *second = first + 81;
        const long type = field(first, 0, 8), begin = field(first, 8, 8),
                   lines = field(second, 24, 8);
        CHECK_INT(field(second, 0, 8), type);
        CHECK_INT(begin, next);
        CHECK(lines > 0);
        for (long k = begin; k < begin + lines; k++)
            CHECK_INT(field(records + (k - 1) * 81, 64, 8), id);
        CHECK_INT(strtol(records + (begin - 1) * 81, NULL, 10), type);
        next += lines;
    }
}

/* Points with names so long that records end within them, more than a thousand of records. */
static batten_model *many_points(int count)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < count; i++) {
        char name[200];
        const double point[3] = {i, 0.1 * i, -1.0 / (i + 1)};
        snprintf(
            name, sizeof name, "%.*s%d", i % 190,
            "a name that goes on and on, from one record to the next and, as it is longer than "
            "sixty-four columns, to the one after that, until it ends somewhere in a column of "
            "a record of its own",
            i);
        CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = 1,
                                                          .points = point}));
    }
    return model;
}

TEST(records_are_numbered_and_entries_name_those_of_their_entity)
{
    static const int counts[] = {1, 2, 9, 400};
    for (int i = 0; i < COUNT(counts); i++) {
        batten_model *model = many_points(counts[i]), *back = NULL;
        char *data = NULL;
        size_t size = 0;
        long records[5];
        CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &data, &size));
        check_sections(data, size, records);
        check_entries(data + 81 * (records[0] + records[1]),
                      data + 81 * (records[0] + records[1] + records[2]), records[2]);
        CHECK(counts[i] < 400 || records[3] > 1000);
        CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
        check_same_model(model, back);
        for (int k = 0; k < counts[i]; k++)
            CHECK(same_numbers(batten_model_object(model, k)->points,
                               batten_model_object(back, k)->points, 3));
        batten_model_unref(back);
        batten_model_unref(model);
        batten_release(data);
    }
}

/* No token is cut: a number stands whole in one record. */
TEST(numbers_are_not_cut_by_the_end_of_a_record)
{
    batten_model *model = NULL;
    double points[3 * 40], knots[42];
    batten_curve *curve = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < 120; i++)
        points[i] = (i % 2 ? -1 : 1) / (3.0 + i) * pow(10, i % 30 - 15);
    for (int i = 0; i < 42; i++)
        knots[i] = i == 0 ? 0 : i == 41 ? 39 : i - 1;
    CHECK_OK(batten_curve_create((batten_points){3, 40, points}, 1, NULL, knots, &curve));
    add_curve(model, "keel", curve);
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &data, &size));
    for (size_t at = 0; at < size; at += 81) {
        size_t end = at + 64;
        if (data[at + 72] != 'P')
            continue;
        while (end > at && data[end - 1] == ' ')
            end--;
        CHECK(end > at && (data[end - 1] == ',' || data[end - 1] == ';'));
    }
    batten_release(data);
    batten_curve_unref(curve);
    batten_model_unref(model);
}
