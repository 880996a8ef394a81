#include "scenes.h"

TEST(the_format_follows_from_the_ending_of_a_name)
{
    static const struct {
        const char *path;
        bool known;
        batten_picture_format format;
    } rows[] = {
        {"hull.png", true, BATTEN_PICTURE_PNG}, {"a.b/HULL.SVG", true, BATTEN_PICTURE_SVG},
        {".pdf", true, BATTEN_PICTURE_PDF},     {"hull.jpeg", false, BATTEN_PICTURE_PNG},
        {"png", false, BATTEN_PICTURE_PNG},     {"", false, BATTEN_PICTURE_PNG}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_picture_format format = BATTEN_PICTURE_PNG;
        CHECK_INT(batten_picture_format_from_name(rows[i].path, &format), rows[i].known);
        CHECK_INT(format, rows[i].format);
    }
}
