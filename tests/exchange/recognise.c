#include "exchange/recognise.h"
#include "exchange/reading.h"

TEST(text_is_recognised_by_its_content)
{
    const struct {
        const char *text;
        batten_object_kind kind;
        const char *name;
    } cases[] = {
        {"1 2\n3 4\n", BATTEN_OBJECT_POINTS, "points"},
        {"x y z\n1 2 3\n", BATTEN_OBJECT_POINTS, "points"},
        {"x,z,half_breadth\n1,2,3\n", BATTEN_OBJECT_OFFSET_TABLE, "offsets"},
        {"x\\z,1\n1,3\n", BATTEN_OBJECT_OFFSET_TABLE, "offsets"},
        {"RAE 2822\n1 0.1\n0 0\n1 -0.1\n", BATTEN_OBJECT_POINTS, "RAE 2822"},
        {"2 3\n0 0\n1 0.1\n0 0\n.5 0\n1 -0.1\n", BATTEN_OBJECT_POINTS, "aerofoil"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = read_noting(cases[i].text, BATTEN_FORMAT_AUTO, "");
        CHECK_INT(batten_model_object(model, 0)->kind, cases[i].kind);
        CHECK_TEXT(batten_model_object(model, 0)->name, cases[i].name);
        batten_model_unref(model);
    }
}

TEST(F7_known_formats_that_are_not_read_are_named)
{
    const struct {
        const char *text, *words;
    } cases[] = {
        {"PK\x03\x04zip", "a ZIP archive"},
        {"%PDF-1.4", "a PDF document"},
        {"\x1f\x8b\x08", "compressed with gzip"},
        {"{\"a\": 1}", "a JSON document"},
        {"batten: 1\nunits: m\n", "a design of Batten"},
        {"\n<?xml version=\"1.0\"?>", "an XML document"},
        {"DBRep_DrawableShape\n\nCASCADE Topology V1, (c)\n", "an OCCT B-rep"},
        {"\nCASCADE Topology V1, (c)\nLocations 0\n", "an OCCT B-rep"},
        {"\nOpen CASCADE Topology V1 (c)\n", "a binary OCCT B-rep"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_refused(cases[i].text, BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED, cases[i].words);
}

TEST(F1_files_with_nothing_in_them_are_refused)
{
    check_refused("", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT, "t: the file is empty");
    const char *const texts[] = {"x",    " ",           "\n\n", "# only a comment\n",
                                 "\x1a", "\xef\xbb\xbf"};
    for (int i = 0; i < COUNT(texts); i++)
        check_refused(texts[i], BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT, "t: the ");
}

TEST(F4_text_in_other_encodings_is_refused_by_name)
{
    batten_model *model = NULL;
    CHECK_STATUS(read_bytes("\xff\xfe"
                            "1\0 \0",
                            6, BATTEN_FORMAT_AUTO, NULL, &model),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("UTF-16");
    CHECK_STATUS(read_bytes("\xfe\xff\0"
                            "1\0 ",
                            6, BATTEN_FORMAT_POINTS, NULL, &model),
                 BATTEN_UNSUPPORTED);
    CHECK_STATUS(read_bytes("1 2\n3\0 4\n", 9, BATTEN_FORMAT_AUTO, NULL, &model),
                 BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("t:2: byte 5 is zero");
    CHECK(model == NULL);
}

TEST(F4_names_keep_their_bytes)
{
    batten_model *model =
        read_noting("x,z,y,line\n0,0,1,k\xfcl \xff\n", BATTEN_FORMAT_OFFSET_TABLE, "");
    CHECK_TEXT(batten_offset_table_line(batten_model_object(model, 0)->offset_table, 0)->name,
               "k\xfcl \xff");
    batten_model_unref(model);
}

TEST(text_that_is_none_of_these_is_refused)
{
    const char *const texts[] = {"hello\n", "hello\nworld\n", "a,b\nc,d\n", "name\n1 2 3\n"};
    for (int i = 0; i < COUNT(texts); i++)
        check_refused(texts[i], BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                      "the format of the file is not recognised");
    check_refused("1\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT, "2 or 3 coordinates");
    check_refused("1 1e999\n1 2\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT, "too large");
    check_refused("x\n\"1 2\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT, "quote");
}

TEST(a_format_comes_with_success_alone)
{
    bat_input input;
    batten_format format = BATTEN_FORMAT_AUTO;
    CHECK_OK(bat_input_begin("OFF BINARY\n", 11, NULL, NULL, NULL, &input));
    CHECK_STATUS(bat_recognise(&input, &format), BATTEN_UNSUPPORTED);
    CHECK_INT(format, BATTEN_FORMAT_AUTO);
}

TEST(F1_a_binary_model_of_FREEship_is_refused_by_name)
{
    static const char bytes[] = "\t\0\0\0FREE!ship\x18\1\0\0";
    batten_model *model = NULL;
    CHECK_STATUS(read_bytes(bytes, sizeof bytes - 1, BATTEN_FORMAT_AUTO, NULL, &model),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("this is a binary FREE!ship model (.fbm), which is not read");
}
