/* The headers that begin each object of a .g2 file, and the classes that they name. */
#include "exchange/g2/g2.h"

#include <batten/text.h>

/* Classes and what they are called; those that are read are marked in read_object. */
static const struct {
    int class;
    const char *name;
} classes[] = {
    {100, "spline curve"},
    {110, "curve on a surface"},
    {120, "line"},
    {130, "circle"},
    {140, "ellipse"},
    {150, "bounded curve"},
    {160, "hyperbola"},
    {170, "parabola"},
    {200, "spline surface"},
    {210, "bounded surface"},
    {240, "composite surface"},
    {250, "plane"},
    {260, "cylinder"},
    {270, "sphere"},
    {280, "cone"},
    {290, "torus"},
    {291, "surface of revolution"},
    {292, "disc"},
    {293, "locally refined surface"},
    {310, "triangles"},
    {400, "points"},
    {410, "line segments"},
    {700, "spline volume"},
};

const char *bat_g2_class_name(int class)
{
    for (size_t k = 0; k < sizeof classes / sizeof classes[0]; k++)
        if (classes[k].class == class)
            return classes[k].name;
    return NULL;
}

/* A header as far as it can be told: a known class at the beginning of a line, a version, and
 * none or four numbers to follow. */
bool bat_g2_is_header(bat_words words)
{
    double value[4] = {0};
    const int line = words.line;
    if (!words.begins_line)
        return false;
    for (int k = 0; k < 4; k++) {
        if (k > 0 && (!bat_words_next(&words) || words.line != line))
            return false;
        if (batten_number_read(words.word.bytes, words.word.length, &value[k], NULL) !=
            BATTEN_OK)
            return false;
    }
    return value[0] == floor(value[0]) && value[0] >= 100 && value[0] < 1000 &&
           bat_g2_class_name((int)value[0]) && (value[1] == 0 || value[1] == 1) &&
           (value[3] == 0 || value[3] == 4);
}

bool bat_g2_is_at_end(const bat_words *words)
{
    bat_words next = *words;
    return !bat_words_next(&next) || bat_g2_is_header(next);
}

batten_status bat_g2_recognise(const bat_input *input, bool *is_g2)
{
    bat_input copy = *input;
    bat_words words;
    bat_words_begin(&words, &copy);
    *is_g2 = bat_words_next(&words) && bat_g2_is_header(words);
    return BATTEN_OK;
}
