/* Writes single groups: a line with a code, a line with a value. */
#include "exchange/dxf/dxf.h"

#include <string.h>

void bat_dxf_text(bat_dxf *dxf, int code, const char *value)
{
    batten_text_add(&dxf->text, "%3d\n%s\n", code, value);
}

void bat_dxf_integer(bat_dxf *dxf, int code, int value)
{
    batten_text_add(&dxf->text, "%3d\n%d\n", code, value);
}

void bat_dxf_real(bat_dxf *dxf, int code, double value)
{
    batten_text_add(&dxf->text, "%3d\n", code);
    batten_text_number(&dxf->text, value == 0 ? 0 : value);
    batten_text_add(&dxf->text, "\n");
}

void bat_dxf_point(bat_dxf *dxf, int code, const double point[3])
{
    for (int k = 0; k < 3; k++)
        bat_dxf_real(dxf, code + 10 * k, point[k]);
}

void bat_dxf_reference(bat_dxf *dxf, int code, int handle)
{
    batten_text_add(&dxf->text, "%3d\n%X\n", code, (unsigned)handle);
}

int bat_dxf_handle(bat_dxf *dxf, int owner)
{
    bat_dxf_reference(dxf, 5, ++dxf->handle);
    bat_dxf_reference(dxf, 330, owner);
    return dxf->handle;
}

/* The code point of a UTF-8 sequence of 2 to 4 bytes. */
static unsigned code_point(const char *text, size_t length)
{
    unsigned value = (unsigned char)text[0] & (0xFFu >> (length + 1));
    for (size_t i = 1; i < length; i++)
        value = value << 6 | ((unsigned char)text[i] & 0x3Fu);
    return value;
}

void bat_dxf_layer(const char *name, char out[BAT_DXF_NAME])
{
    size_t used = 0;
    while (*name && used + 8 < BAT_DXF_NAME) {
        const size_t length = bat_utf8_length(name);
        const bool bad = length == 0 || (unsigned char)*name < ' ' || *name == 127 ||
                         strchr("<>/\\\":;?*|=',`", *name);
        const unsigned code = length > 1 ? code_point(name, length) : 0;
        if (length > 1 && code < 0x10000) {
            static const char digits[] = "0123456789ABCDEF";
            memcpy(out + used, "\\U+", 3);
            for (int k = 0; k < 4; k++)
                out[used + 3 + (size_t)k] = digits[code >> (12 - 4 * k) & 15];
            used += 7;
        } else {
            out[used++] = bad || length > 1 ? '_' : *name;
        }
        name += length ? length : 1;
    }
    out[used] = '\0';
    if (used == 0)
        memcpy(out, "0", 2);
}
