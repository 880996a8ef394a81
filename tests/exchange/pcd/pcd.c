#include "exchange/pcd/pcd.h"

#include "exchange/meshes/meshes.h"

#define HEADER "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
#define XYZ HEADER "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"

TEST(points_of_text_are_read)
{
    static const char *const texts[] = {
        XYZ "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n",
        XYZ "WIDTH 2\nHEIGHT 1\nDATA ascii\r\n1 2 3\r\n\r\n4 5 6",
        HEADER "FIELDS _ z y x\nSIZE 1 4 4 4\nTYPE U F F F\nCOUNT 2 1 1 1\nPOINTS 2\nDATA "
               "ascii\n0 0 3 2 1\n0 0 6 5 4\n"};
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = read_noting(texts[i], BATTEN_FORMAT_AUTO, "");
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->point_count, 2);
        for (int k = 0; k < 6; k++)
            CHECK_BITS(object->points[k], (double)(k + 1));
        batten_model_unref(model);
    }
}

TEST(points_of_bytes_are_read)
{
    static const char bytes[] =
        HEADER "FIELDS x a y z\nSIZE 8 2 4 1\nTYPE F U F I\nCOUNT 1 2 1 1\nPOINTS 1\nDATA "
               "binary\n"
               "\0\0\0\0\0\0\xf8\x3f"
               "\1\2\3\4"
               "\0\0\0\x40"
               "\xfe";
    batten_model *model = NULL;
    CHECK_OK(read_bytes(bytes, sizeof bytes - 1, BATTEN_FORMAT_AUTO, NULL, &model));
    const double *p = batten_model_object(model, 0)->points;
    CHECK(p[0] == 1.5 && p[1] == 2 && p[2] == -2);
    batten_model_unref(model);
}

/* Three points, 36 bytes: x's, y's, z's. Literals, a run, and a copy from before. */
TEST(compressed_points_are_read)
{
    static const char bytes[] = XYZ "POINTS 3\nDATA binary_compressed\n"
                                    "\x0e\0\0\0"
                                    "\x24\0\0\0"
                                    "\x03\0\0\x80\x3f" /* 1 */
                                    "\xc0\x03"         /* 8 bytes more of it */
                                    "\x03\0\0\0\x40"   /* 2 */
                                    "\xe0\x0b\x03";    /* 20 bytes more */
    char packed[sizeof bytes];
    memcpy(packed, bytes, sizeof bytes);
    packed[strlen(XYZ "POINTS 3\nDATA binary_compressed\n")] = 15;
    batten_model *model = NULL;
    char *all = test_array(sizeof bytes, 1);
    memcpy(all, packed, sizeof bytes - 1);
    CHECK_OK(read_bytes(all, sizeof bytes - 1, BATTEN_FORMAT_AUTO, NULL, &model));
    const double *p = batten_model_object(model, 0)->points;
    for (int i = 0; i < 3; i++)
        CHECK(p[3 * i] == 1 && p[3 * i + 1] == 2 && p[3 * i + 2] == 2);
    batten_model_unref(model);
}

TEST(damaged_lzf_is_refused)
{
    static const struct {
        const char *bytes;
        size_t size;
        const char *words;
    } cases[] = {{"\x03"
                  "ab",
                  3, "damaged"},
                 {"\x20\x05", 2, "damaged"},
                 {"\x00"
                  "a\xe0",
                  3, "damaged"},
                 {"\x00"
                  "a\xe0\xff",
                  4, "damaged"},
                 {"\x00"
                  "a\xe0\xff\x00",
                  5, "damaged"},
                 {"\x00"
                  "a",
                  2, "end after 1 bytes instead of 8"},
                 {"", 0, "end after 0 bytes instead of 8"}};
    for (int i = 0; i < COUNT(cases); i++) {
        char to[8];
        CHECK_STATUS(bat_lzf(cases[i].bytes, cases[i].size, to, sizeof to), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(cases[i].words);
    }
}

TEST(N1_points_that_are_nowhere_are_told)
{
    batten_model *model = read_noting(XYZ "POINTS 2\nDATA ascii\nnan nan nan\n4 5 6\n",
                                      BATTEN_FORMAT_PCD, "1 point has no position (NaN); not kept");
    CHECK_INT(batten_model_object(model, 0)->point_count, 1);
    batten_model_unref(model);
    const char *text = XYZ "POINTS 2\nDATA ascii\n1 2\n4 5 6\n";
    model = read_partly(text, strlen(text), BATTEN_FORMAT_PCD,
                        "point 1 is left out: a coordinate is missing or not a number");
    batten_model_unref(model);
    model = read_noting(HEADER "FIELDS x y z rgb\nPOINTS 1\nVIEWPOINT 1 0 0 1 0 0 0\nDATA "
                               "ascii\n1 2 3 4\n",
                        BATTEN_FORMAT_PCD, "left out of 1 point: 1 further field");
    batten_model_unref(model);
}

TEST(F1_headers_of_clouds_that_are_none_are_refused_by_line)
{
    static const struct {
        const char *text, *words;
    } cases[] = {
        {"", "t: the file is empty"},
        {HEADER "NONSENSE\n", "t:3: bad header: unknown header line"},
        {HEADER "FIELDS x y\nDATA ascii\n", "there is no field z"},
        {HEADER "FIELDS x y z\nSIZE 4 4\n", "fewer words than fields"},
        {HEADER "FIELDS x y z\nSIZE 4 4 9\n", "a size or count is not a whole number"},
        {HEADER "FIELDS x y z\nCOUNT 1 1 0\n", "a size or count is not a whole number"},
        {HEADER "FIELDS x y z\nTYPE F F Q\n", "a type must be I, U or F"},
        {HEADER "POINTS -1\n", "a count is not a whole number"},
        {HEADER "FIELDS x y z\nDATA zip\n", "data must be ascii"},
        {HEADER "FIELDS x y z\nSIZE 3 4 4\nPOINTS 1\nDATA binary\n", "type F cannot have 3 bytes"},
        {XYZ "POINTS 5\nDATA ascii\n", "no point could be read"},
        {XYZ "POINTS 5\nDATA binary_compressed\n", "0 bytes of compressed points are promised"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_refused(cases[i].text, BATTEN_FORMAT_PCD, BATTEN_BAD_FORMAT, cases[i].words);
}

TEST(S2_a_thousand_million_points_in_a_small_cloud_are_refused)
{
    static const char *const forms[] = {"ascii", "binary", "binary_compressed"};
    for (int i = 0; i < 3; i++) {
        char text[300];
        batten_limits limits = batten_limits_defaults();
        batten_read_options options = batten_read_defaults();
        batten_model *model = NULL;
        const int length =
            snprintf(text, sizeof text, XYZ "POINTS 9000000\nDATA %s\n", forms[i]);
        memcpy(text + length, "\4\0\0\0\0\x6d\x6f\6xxxx", 12);
        limits.memory_bytes = 65536;
        options.limits = &limits;
        options.format = BATTEN_FORMAT_PCD;
        const batten_status status = batten_read_memory(
            text, (size_t)length + (i == 1 ? 8 : 12) * (i > 0), &options, NULL, NULL, &model);
        CHECK(status == BATTEN_BAD_FORMAT || status == BATTEN_OUT_OF_MEMORY);
        CHECK(model == NULL);
    }
    check_refused(XYZ "POINTS 1000000000\nDATA ascii\n", BATTEN_FORMAT_PCD, BATTEN_TOO_LARGE,
                  "1000000000 points; the limit is 10000000");
}

TEST(F2_clouds_that_are_cut_anywhere_are_refused_or_read_in_part)
{
    const char *text = XYZ "POINTS 2\nDATA ascii\n1 2 3\n4 5 6\n";
    check_cuts(text, strlen(text) - 2, BATTEN_FORMAT_PCD);
    static const char bytes[] = XYZ "POINTS 2\nDATA binary\n12345678901234567890123";
    check_cuts(bytes, sizeof bytes, BATTEN_FORMAT_PCD);
}
