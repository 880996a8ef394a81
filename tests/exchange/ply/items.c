/* Items of elements: their lines, their numbers, what is cut and what is passed over. */
#include "exchange/listed.h"
#include "exchange/meshes/meshes.h"

#define VERTICES(n) \
    "element vertex " n "\nproperty float x\nproperty float y\nproperty float z\n"
#define FACES(n) "element face " n "\nproperty list uchar int vertex_indices\n"

/* Blank lines count as lines and not as items; headers of 8 lines and, with faces, 10. */
static const struct {
    const char *body;
    batten_status status;
    const char *listing;
} texts[] = {
    {VERTICES("3") "end_header\n0 0 0\n1 0 0\n0 1 0\n", BATTEN_OK, ""},
    {VERTICES("3") "end_header\n\n0 0 0\n \n\n1 0\n0 1 0\n", BATTEN_PARTLY_READ,
     "12: vertex 2 is left out: a number is missing\n"},
    {VERTICES("3") "end_header\nx 0 0\n1 0 inf\n0 1 0\n", BATTEN_PARTLY_READ,
     "8: vertex 1 is left out: a coordinate is not finite\n"
     "9: vertex 2 is left out: a coordinate is not finite\n"},
    {VERTICES("3") FACES("2") "end_header\n0 0 0\n1 0 0\n0 1 0\n\n3 0 1\n3 0 1 2\n",
     BATTEN_PARTLY_READ,
     "14: face 1 is left out: a number is missing, or its count is invalid\n"},
    {FACES("3") VERTICES("3") "end_header\n3 0 1 2\n\n3 0 1 7\n3 0\n0 0 0\n1 0 0\n0 1 0\n",
     BATTEN_PARTLY_READ,
     "12: face 2 is left out: its corner 3 is vertex 8, which does not exist\n"
     "13: face 3 is left out: a number is missing, or its count is invalid\n"},
    {VERTICES("3") FACES("2") "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", BATTEN_PARTLY_READ,
     "0: 1 of 2 items 'face' are in the file\n"},
};

TEST(what_is_wrong_with_an_item_is_said_with_its_line)
{
    for (int i = 0; i < COUNT(texts); i++) {
        char text[500];
        snprintf(text, sizeof text, "ply\nformat ascii 1.0\n%s", texts[i].body);
        check_listed(text, BATTEN_FORMAT_PLY, texts[i].status, texts[i].listing);
    }
}

/* What comes behind the last item is noted, also where faces were read after the vertices. */
TEST(text_behind_the_last_item_is_noted_where_it_stands)
{
    static const char *const orders[] = {
        VERTICES("3") FACES("1") "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        FACES("1") VERTICES("3") "end_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n"};
    for (int k = 0; k < 4; k++) {
        char text[500];
        snprintf(text, sizeof text, "ply\nformat ascii 1.0\n%s%s", orders[k / 2],
                 k % 2 ? "\n\nmore\n" : "\n");
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(5, &notes));
        CHECK_OK(read_text(text, BATTEN_FORMAT_PLY, notes, &model));
        char said[100];
        snprintf(said, sizeof said,
                 "7 bytes follow where the file should end, at byte %zu; not read",
                 strlen(text) - 7);
        if (batten_notes_dropped(notes) == 0 && test_cases(10) >= 10) {
            CHECK_INT(batten_notes_count(notes), k % 2);
            CHECK(k % 2 == 0 || has_note(notes, said));
        }
        CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

/* The largest and smallest numbers of each type, in bytes; a list of any type of count. */
TEST(whole_numbers_of_every_size_keep_their_sign)
{
    static const struct {
        const char *name;
        int bytes;
        uint64_t bits;
        double value;
    } cases[] = {{"char", 1, 0x7f, 127},
                 {"char", 1, 0x80, -128},
                 {"uchar", 1, 0xff, 255},
                 {"short", 2, 0x7fff, 32767},
                 {"short", 2, 0x8000, -32768},
                 {"ushort", 2, 0xffff, 65535},
                 {"int", 4, 0x7fffffff, 2147483647.0},
                 {"int", 4, 0x80000000, -2147483648.0},
                 {"uint", 4, 0xffffffff, 4294967295.0},
                 {"int", 4, 0x01020304, 0x01020304}};
    for (int i = 0; i < COUNT(cases); i++)
        for (int big = 0; big < 2; big++) {
            char data[300];
            batten_model *model = NULL;
            size_t at = (size_t)snprintf(
                data, sizeof data,
                "ply\nformat binary_%s_endian 1.0\nelement vertex 1\nproperty %s x\n"
                "property uchar y\nproperty uchar z\nend_header\n",
                big ? "big" : "little", cases[i].name);
            for (int k = 0; k < cases[i].bytes; k++)
                data[at++] = (char)(unsigned char)(cases[i].bits >>
                                                   (8 * (big ? cases[i].bytes - 1 - k : k)));
            data[at++] = 3;
            data[at++] = 4;
            CHECK_OK(read_bytes(data, at, BATTEN_FORMAT_PLY, NULL, &model));
            const double *point = batten_model_object(model, 0)->points;
            CHECK_BITS(point[0], cases[i].value);
            CHECK(point[1] == 3 && point[2] == 4);
            batten_model_unref(model);
            model = NULL;
            CHECK(read_bytes(data, at - 1, BATTEN_FORMAT_PLY, NULL, &model) != BATTEN_OK);
            batten_model_unref(model);
        }
}
