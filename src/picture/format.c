/* Formats of pictures by the ending of a file's name. */
#define _XOPEN_SOURCE 700
#include <batten/picture.h>

#include <string.h>
#include <strings.h>

bool batten_picture_format_from_name(const char *path, batten_picture_format *format)
{
    static const struct {
        const char *ending;
        batten_picture_format format;
    } endings[] = {{".png", BATTEN_PICTURE_PNG},
                   {".svg", BATTEN_PICTURE_SVG},
                   {".pdf", BATTEN_PICTURE_PDF}};

    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof endings / sizeof endings[0]; i++)
        if (strcasecmp(dot, endings[i].ending) == 0) {
            *format = endings[i].format;
            return true;
        }
    return false;
}
