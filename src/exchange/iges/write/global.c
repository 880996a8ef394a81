/* The global section of an IGES file, and the file put together from its five sections. */
#include "exchange/iges/write/writing.h"

#include <batten/text.h>
#include <string.h>

static const char shape[] = "dddd-dd-ddTdd:dd:dd";

static bool has_shape(const char *date)
{
    for (size_t i = 0; date && shape[i]; i++)
        if (shape[i] == 'd' ? date[i] < '0' || date[i] > '9' : date[i] != shape[i])
            return false;
    return date && !date[sizeof shape - 1];
}

/* "2026-11-21T10:25:00" as "20261121.102500"; another form gives the neutral date. */
static void write_date(const char *date, char out[16])
{
    memcpy(out, "20000101.000000", 16);
    if (!has_shape(date))
        return;
    size_t k = 0;
    for (size_t i = 0; shape[i]; i++) {
        if (shape[i] == 'd')
            out[k++] = date[i];
        if (shape[i] == 'T')
            out[k++] = '.';
    }
}

static void put_unit(bat_iges_section *global, double metres)
{
    static const char *const names[] = {"IN", "MM",  "",   "FT", "MI", "M",
                                        "KM", "MIL", "UM", "CM", "UIN"};
    const int flag = bat_iges_flag_of_unit(metres);
    bat_iges_put_integer(global, flag, ',');
    bat_iges_put_string(global, names[flag - 1], ',');
}

static void put_global(const bat_iges_writing *w, bat_iges_section *global,
                       const batten_write_options *options, double unit)
{
    static const int sizes[] = {32, 38, 6, 308, 17};
    const char *const begin[] = {",",           ";",      options->name,
                                 options->name, "Batten", batten_version()};
    char date[16];
    write_date(options->date, date);
    for (size_t k = 0; k < sizeof begin / sizeof begin[0]; k++)
        bat_iges_put_string(global, begin[k], ',');
    for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k++)
        bat_iges_put_integer(global, sizes[k], ',');
    bat_iges_put_string(global, options->name, ',');
    bat_iges_put_real(global, 1, ',');
    put_unit(global, unit);
    bat_iges_put_integer(global, 1, ',');
    bat_iges_put_real(global, 0, ',');
    bat_iges_put_string(global, date, ',');
    bat_iges_put_real(global, w->tolerance, ',');
    bat_iges_put_real(global, w->largest, ',');
    bat_iges_put_string(global, "", ',');
    bat_iges_put_string(global, "", ',');
    bat_iges_put_integer(global, 11, ',');
    bat_iges_put_integer(global, 0, ',');
    bat_iges_put_string(global, date, ';');
    bat_iges_section_flush(global);
}

batten_status bat_iges_join(bat_iges_writing *w, const batten_write_options *options,
                            double unit, batten_text *text)
{
    batten_text front = BATTEN_TEXT;
    bat_iges_section global;
    batten_text_add(&front, "%-72sS%7d\n", "Written by Batten", 1);
    bat_iges_section_begin(&global, 'G', &front);
    put_global(w, &global, options, unit);
    batten_text_bytes(&front, w->directory.bytes, w->directory.length);
    const bool failed = front.failed || w->directory.failed;
    if (!failed)
        bat_text_insert(text, front.bytes, front.length);
    batten_text_add(text, "S%7dG%7dD%7dP%7d%40sT%7d\n", 1, global.count, w->directory_count,
                    w->data.count, "", 1);
    batten_text_free(&front);
    return failed || text->failed ? BATTEN_OUT_OF_MEMORY : BATTEN_OK;
}
