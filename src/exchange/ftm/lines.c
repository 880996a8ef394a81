/* The lines of a .ftm file and their numbers. */
#include "exchange/ftm/reading.h"
#include "exchange/reading/scan.h"
#include <batten/text.h>
#include <limits.h>

batten_status bat_ftm_split_lines(bat_ftm_reading *r)
{
    bat_span line;
    size_t next = 0;
    batten_status status =
        bat_input_limit(r->input, 0, r->input->size, UINT32_MAX, "bytes in an FTM file");
    while (status == BATTEN_OK) {
        const uint32_t at = (uint32_t)next;
        if (!bat_next_line(r->input, &next, &line))
            break;
        status = bat_list_add(r->input, &r->lines, &at);
    }
    return status;
}

bat_span bat_ftm_line_of(const bat_ftm_reading *r, size_t index)
{
    bat_span line = {"", 0};
    if (index < r->lines.count) {
        size_t at = ((const uint32_t *)r->lines.items)[index];
        bat_next_line(r->input, &at, &line);
    }
    return line;
}

int bat_ftm_numbers_of(bat_span line, int most, double *values)
{
    int count = 0;
    for (size_t i = 0; i < line.length;) {
        while (i < line.length && bat_is_blank(line.bytes[i]))
            i++;
        const size_t begin = i;
        while (i < line.length && !bat_is_blank(line.bytes[i]))
            i++;
        if (i == begin)
            break;
        if (count == most || batten_number_read(line.bytes + begin, i - begin, &values[count],
                                                NULL) != BATTEN_OK)
            return -1;
        count++;
    }
    return count;
}

bool bat_ftm_is_whole(const bat_ftm_reading *r, size_t index, int *value)
{
    const bat_span line = bat_ftm_line_of(r, index);
    bat_scan words = bat_scan_begin(line.bytes, line.length);
    bat_span word, more;
    int64_t number = 0;
    if (!bat_next_in_line(&words, &word) || bat_next_in_line(&words, &more) ||
        !bat_word_integer(word, INT_MIN, INT_MAX, &number))
        return false;
    *value = (int)number;
    return true;
}

batten_status bat_ftm_next_whole(bat_ftm_reading *r, const char *what, int low, int high,
                                 int *value)
{
    if (!bat_ftm_is_whole(r, r->at, value) || *value < low || *value > high)
        return bat_input_fail(r->input, BATTEN_BAD_FORMAT, (int)r->at + 1,
                              "%s is not a whole number from %d to %d", what, low, high);
    r->at++;
    return BATTEN_OK;
}

batten_status bat_ftm_next_count(bat_ftm_reading *r, const char *what, size_t least, int *count)
{
    const size_t left = r->at < r->lines.count ? r->lines.count - r->at : 0;
    const size_t most = left / least;
    return bat_ftm_next_whole(r, what, 0, most < 1000000000 ? (int)most : 1000000000, count);
}
