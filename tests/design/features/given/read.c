#include "design/expect.h"

/* Files that a design reads: their unit, their scale, and what is kept of a table of offsets. */

static void put_file(const char *name, const char *text)
{
    FILE *file = fopen(test_scratch(name), "w");
    CHECK(file != NULL);
    fputs(text, file);
    fclose(file);
}

TEST(numbers_of_a_file_are_scaled_to_the_unit_of_the_design)
{
    static const struct {
        const char *read, *output;
        batten_status status;
        const char *words;
    } cases[] = {
        {"points.xyz", "m.txt: {measure: r}", BATTEN_OK,
         "2 points\n  box 1000 2000 0  to  3000 4000 0\n"},
        {"points.xyz, unit: mm", "m.txt: {measure: r}", BATTEN_OK,
         "2 points\n  box 1 2 0  to  3 4 0\n"},
        {"points.xyz, unit: mm, scale: 2", "m.txt: {measure: r}", BATTEN_OK,
         "box 2 4 0  to  6 8 0\n"},
        {"points.xyz, scale: 0.5", "m.txt: {measure: r}", BATTEN_OK,
         "box 500 1000 0  to  1500 2000 0\n"},
        {"points.xyz, scale: 0", "m.txt: {measure: r}", BATTEN_BAD_ARGUMENT,
         "'scale' must be above 0, not 0"},
        {"points.xyz, unit: furlnog", "m.txt: {measure: r}", BATTEN_BAD_ARGUMENT,
         "'unit' is 'furlnog', which is not a known unit of length"},
        {"points.xyz, format: step", "m.txt: {measure: r}", BATTEN_BAD_FORMAT, ""},
        {"missing.xyz", "m.txt: {measure: r}", BATTEN_FILE_ERROR, "missing.xyz"},
        {"table.csv", "m.txt: {measure: r}", BATTEN_OK,
         "4 stations, |\n  box 0 0 0  to  6 3 2\n"},
        {"table.csv, scale: 2", "m.txt: {measure: r}", BATTEN_OK, "box 0 0 0  to  12 6 4\n"},
        {"table.csv, unit: mm", "m.txt: {measure: r}", BATTEN_OK,
         "box 0 0 0  to  0.006 0.003 0.002\n"},
        {"table.csv, upside-down: yes", "m.txt: {measure: r}", BATTEN_OK,
         "box 0 0 -2  to  6 3 0\n"},
        {"table.csv, reverse: yes", "m.txt: {measure: r}", BATTEN_OK,
         "box -6 0 0  to  0 3 2\n"},
        {"table.csv, x: [1, 5]", "m.txt: {measure: r}", BATTEN_OK, "2 stations|box 2 |to  4 "},
        {"table.csv, x: [2, 4]", "m.txt: {measure: r}", BATTEN_OK,
         "2 stations|box 2 0 0  to  4 3 2\n"},
        {"table.csv, y: [0.5, 2.5]", "m.txt: {measure: r}", BATTEN_OK, " 0.5 |!  to  6 3 2"},
        {"table.csv, z: [1, 2]", "m.txt: {measure: r}", BATTEN_OK, "to  6 3 2\n|!box 0 0 0"},
        {"table.csv, trim-centre: yes", "m.txt: {measure: r}", BATTEN_OK, "11 points"},
    };
    put_file("points.xyz", "1000 2000\n3000 4000\n");
    put_file("table.csv", "x_m,z_m,half_breadth_m,line\n"
                          "0,0,0,k\n0,1,0,a\n0,2,1,b\n"
                          "2,0,0,k\n2,1,0.5,a\n2,2,2,b\n"
                          "4,0,0,k\n4,1,1,a\n4,2,3,b\n"
                          "6,0,0,k\n6,1,0.5,a\n6,2,2,b\n");
    for (int i = 0; i < COUNT(cases); i++) {
        char before[300];
        snprintf(before, sizeof before, "  r: {read: %s}\n", cases[i].read);
        expect_outputs(before, &(expect_row){cases[i].output, cases[i].status, cases[i].words},
                       1);
    }
}
