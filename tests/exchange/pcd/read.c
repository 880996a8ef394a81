/* What is said of clouds of points, to the letter. */
#include "exchange/listed.h"

#define XYZ "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
#define FIELDS4 "FIELDS x y z i\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"

static const struct {
    const char *text;
    batten_status status;
    const char *listing;
} listed[] = {
    {XYZ "WIDTH 1\nHEIGHT 2\nDATA ascii\n1 2 3\n4 5 6\n", BATTEN_OK, ""},
    {XYZ "WIDTH 2\nHEIGHT 3\nDATA ascii\n1 2 3\n4 5 6\n", BATTEN_PARTLY_READ,
     "0: 2 of 6 points are in the file\n"},
    {XYZ "WIDTH 2\nDATA ascii\n1 2 3\n4 5 6\n", BATTEN_OK, ""},
    {XYZ "WIDTH 9\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n", BATTEN_OK, ""},
    {XYZ "POINTS 2\nDATA ascii\n1 2 3\n\n4 5 6\n7 8 9\n", BATTEN_OK,
     "0: 6 bytes follow where the file should end, at byte 80; not read\n"},
    {XYZ "POINTS 2\nDATA ascii\n1 2 3\n4 5\n", BATTEN_PARTLY_READ,
     "8: point 2 is left out: a coordinate is missing or not a number\n"},
    {XYZ "POINTS 2\nDATA ascii\n\n1 x 3\n4 5 6\n", BATTEN_PARTLY_READ,
     "8: point 1 is left out: a coordinate is missing or not a number\n"},
    {XYZ "POINTS 3\nDATA ascii\n1 nan 3\n-nan 5 6\n7 8 9\n", BATTEN_OK,
     "~0: 2 points have no position (NaN); not kept\n"},
    {XYZ "POINTS 2\nDATA ascii\n1 2 NaN\n7 8 9\n", BATTEN_OK,
     "~0: 1 point has no position (NaN); not kept\n"},
    {XYZ "POINTS 1\nDATA ascii\n1 2 nan\n", BATTEN_BAD_FORMAT,
     "~0: 1 point has no position (NaN); not kept\nt: no point could be read\n"},
    {FIELDS4 "POINTS 1\nDATA ascii\n1 2 3\n", BATTEN_OK,
     "0: of points only coordinates are kept; left out of 1 point: 1 further field\n"},
    {FIELDS4 "POINTS 2\nDATA ascii\n1 2 3 4\n1 2 3 4\n", BATTEN_OK,
     "0: of points only coordinates are kept; left out of 2 points: 1 further field\n"},
    {"FIELDS x y z _\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 4\nPOINTS 1\nDATA ascii\n1 2 3\n",
     BATTEN_OK, ""},
    {XYZ "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA ascii\n1 2 3\n", BATTEN_OK, ""},
    {XYZ "VIEWPOINT 0 0 0 1 0 0 0.5\nPOINTS 1\nDATA ascii\n1 2 3\n", BATTEN_OK,
     "~5: the sensor has a position of its own; the points are not moved\n"},
    {XYZ "VIEWPOINT 0 0 0 0 0 0 0\nPOINTS 1\nDATA ascii\n1 2 3\n", BATTEN_OK,
     "~5: the sensor has a position of its own; the points are not moved\n"},
    {XYZ "VIEWPOINT 0 0 0 1 0 0\nPOINTS 1\nDATA ascii\n1 2 3\n", BATTEN_OK,
     "~5: the sensor has a position of its own; the points are not moved\n"},
    {XYZ "POINTS 1\nDATA ascii\n1e-999 2 3\n", BATTEN_OK,
     "7: the number 1e-999 is too small for a double; read as 0\n"},
    {"FIELDS x y\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\nPOINTS 1\nDATA ascii\n1 2\n",
     BATTEN_BAD_FORMAT, "t:6: there is no field z with one value for each point\n"},
    {"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 2 1\nPOINTS 1\nDATA ascii\n1 2 3 4\n",
     BATTEN_BAD_FORMAT, "t:6: there is no field y with one value for each point\n"},
    {"FIELDS x y z\nSIZE 4 4\n", BATTEN_BAD_FORMAT,
     "t:2: bad header: there are fewer words than fields\n"},
    {"FIELDS x\nTYPE D\n", BATTEN_BAD_FORMAT, "t:2: bad header: a type must be I, U or F\n"},
    {"FIELDS x\nTYPE FF\n", BATTEN_BAD_FORMAT, "t:2: bad header: a type must be I, U or F\n"},
    {"FIELDS x\nSIZE 9\n", BATTEN_BAD_FORMAT,
     "t:2: bad header: a size or count is not a whole number that is allowed\n"},
    {"FIELDS x\nSIZE 0\n", BATTEN_BAD_FORMAT,
     "t:2: bad header: a size or count is not a whole number that is allowed\n"},
    {"FIELDS x\nCOUNT 65537\n", BATTEN_BAD_FORMAT,
     "t:2: bad header: a size or count is not a whole number that is allowed\n"},
    {"WIDTH -1\n", BATTEN_BAD_FORMAT, "t:1: bad header: a count is not a whole number\n"},
    {"# c\nHEIGHT\n", BATTEN_BAD_FORMAT, "t:2: bad header: a count is not a whole number\n"},
    {"POINTS 1.5\n", BATTEN_BAD_FORMAT, "t:1: bad header: a count is not a whole number\n"},
    {"DATA text\n", BATTEN_BAD_FORMAT,
     "t:1: bad header: data must be ascii, binary or binary_compressed\n"},
    {"VERSION .7\nEDGES 3\n", BATTEN_BAD_FORMAT, "t:2: bad header: unknown header line\n"},
    {XYZ "POINTS 1\n", BATTEN_BAD_FORMAT, "t:6: the file ends within the header\n"},
    {"FIELDS x y z\nSIZE 3 4 4\nTYPE F F F\nCOUNT 1 1 1\nPOINTS 1\nDATA binary\n123456789012",
     BATTEN_BAD_FORMAT, "t:6: a number of type F cannot have 3 bytes\n"},
    {"FIELDS x y z\nSIZE 4 4 1\nTYPE F F F\nCOUNT 1 1 1\nPOINTS 1\nDATA binary\n123456789012",
     BATTEN_BAD_FORMAT, "t:6: a number of type F cannot have 1 byte\n"},
    {"FIELDS x y z\nSIZE 4 5 4\nTYPE F I F\nCOUNT 1 1 1\nPOINTS 1\nDATA binary\n1234567890123",
     BATTEN_BAD_FORMAT, "t:6: a number of type I cannot have 5 bytes\n"},
    {XYZ "POINTS 2\nDATA binary\n123456789012", BATTEN_PARTLY_READ,
     "0: 1 of 2 points are in the file\n"},
    {XYZ "POINTS 1\nDATA binary\n123456789012x", BATTEN_OK,
     "0: 1 byte follows where the file should end, at byte 80; not read\n"},
    {XYZ "POINTS 1\nDATA binary_compressed\n1234567", BATTEN_BAD_FORMAT,
     "t: 0 bytes of compressed points are promised, 0 are left\n"}};

TEST(what_is_wrong_in_PCD_is_named_with_its_line)
{
    for (int i = 0; i < COUNT(listed); i++)
        check_listed(listed[i].text, BATTEN_FORMAT_PCD, listed[i].status, listed[i].listing);
}

/* A number of a type and a size as bytes, the low one first. */
TEST(whole_numbers_of_each_size_and_sign_are_decoded)
{
    static const struct {
        char type;
        int size;
        const char *bytes;
        double value;
    } cases[] = {{'U', 1, "\xff", 255},
                 {'I', 1, "\xff", -1},
                 {'I', 1, "\x7f", 127},
                 {'I', 1, "\x80", -128},
                 {'U', 2, "\x02\x01", 258},
                 {'I', 2, "\xfe\xff", -2},
                 {'U', 4, "\x04\x03\x02\x01", 16909060},
                 {'I', 4, "\xff\xff\xff\x7f", 2147483647},
                 {'I', 4, "\x01\x01\x01\x80", -2147417855},
                 {'U', 8, "\x01\x01\x01\x01\x01\x01\x01\x01", 72340172838076673.0},
                 {'I', 8, "\x01\x01\x01\x01\x01\x01\x01\xff", -71775015237779199.0},
                 {'I', 8, "\xff\xff\xff\xff\xff\xff\xff\xff", -1},
                 {'I', 8, "\x18\xfc\xff\xff\xff\xff\xff\xff", -1000},
                 {'I', 8, "\0\0\0\0\0\0\0\x80", -9223372036854775808.0},
                 {'F', 4, "\xdb\x0f\x49\x40", 3.1415927410125732},
                 {'F', 8, "\x18\x2d\x44\x54\xfb\x21\x09\x40", 3.141592653589793}};
    for (int i = 0; i < COUNT(cases); i++)
        for (int first = 0; first < 3; first++) { /* as x, y or z; the others are bytes */
            char text[300];
            static const char *const names[] = {"x y z", "y x z", "z y x"};
            const int at = first == 0 ? 0 : first == 1 ? 1 : 2;
            int length = snprintf(text, sizeof text,
                                  "FIELDS %s\nSIZE %d 1 1\nTYPE %c U U\nCOUNT 1 1 1\nPOINTS 1\n"
                                  "DATA binary\n",
                                  names[first], cases[i].size, cases[i].type);
            memcpy(text + length, cases[i].bytes, (size_t)cases[i].size);
            memcpy(text + length + cases[i].size, "\x05\x06", 2);
            length += cases[i].size + 2;
            batten_model *model =
                read_listed(text, (size_t)length, BATTEN_FORMAT_PCD, BATTEN_OK, "");
            const double *p = batten_model_object(model, 0)->points;
            CHECK_NEAR(p[at], cases[i].value, fabs(cases[i].value) * 1e-15);
            CHECK(p[0] + p[1] + p[2] == cases[i].value + 11 || cases[i].size == 8 ||
                  cases[i].type == 'F');
            batten_model_unref(model);
        }
}

TEST(points_of_a_cloud_are_limited)
{
    batten_read_options options = batten_read_defaults();
    batten_limits limits = batten_limits_defaults();
    batten_model *model = NULL;
    static const char text[] = XYZ "POINTS 2\nDATA ascii\n1 2 3\n4 5 6\n";
    options.limits = &limits;
    options.format = BATTEN_FORMAT_PCD;
    limits.points = 1;
    CHECK_STATUS(batten_read_memory(text, strlen(text), &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("line 6: 2 points; the limit is 1");
    limits.points = 2;
    CHECK_OK(batten_read_memory(text, strlen(text), &options, NULL, NULL, &model));
    batten_model_unref(model);
}
