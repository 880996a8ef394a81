/* Reads numbers from text in which line ends mean nothing. */
#include "exchange/reading/words.h"

#include <batten/text.h>
#include <string.h>

void bat_words_begin(bat_words *words, bat_input *input)
{
    *words = (bat_words){
        .input = input, .scan = bat_scan_begin(input->data, input->size), .line = 0};
}

bool bat_words_next(bat_words *words)
{
    const bool found = bat_next_word(&words->scan, &words->word);
    words->begins_line = found && words->scan.line > words->line;
    words->line = words->scan.line;
    return found;
}

static size_t bytes_left(const bat_words *words)
{
    return (size_t)(words->scan.end - words->scan.at);
}

static batten_status ended(const bat_words *words, const char *what)
{
    return bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                          "the text ends where %s is expected", what);
}

batten_status bat_words_real(bat_words *words, const char *what, double *value)
{
    if (!bat_words_next(words))
        return ended(words, what);
    const batten_status status =
        batten_number_read(words->word.bytes, words->word.length, value, NULL);
    if (status == BATTEN_OK) {
        bat_input_vanished(words->input, words->line, "", words->word, *value);
        return BATTEN_OK;
    }
    char shown[BAT_SHOWN_SIZE];
    return bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line, "%s is '%.60s', %s",
                          what, bat_shown(words->word.bytes, words->word.length, shown),
                          status == BATTEN_OVERFLOW ? "which is too large for a number"
                                                    : "not a number");
}

batten_status bat_words_integer(bat_words *words, const char *what, int low, int high,
                                int *value)
{
    int64_t number = 0;
    if (!bat_words_next(words))
        return ended(words, what);
    if (bat_word_integer(words->word, low, high, &number)) {
        *value = (int)number;
        return BATTEN_OK;
    }
    char shown[BAT_SHOWN_SIZE];
    return bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                          "%s is %.60s, not a whole number from %d to %d", what,
                          bat_shown(words->word.bytes, words->word.length, shown), low, high);
}

batten_status bat_words_check(const bat_words *words, const char *what, size_t count,
                              size_t least)
{
    /* A word and the white space after it take two bytes at least. */
    const size_t room = (bytes_left(words) + 1) / 2;
    if (count <= room / least)
        return BATTEN_OK;
    return bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                          "%zu %s cannot stand in the %zu bytes that are left", count, what,
                          bytes_left(words));
}

batten_status bat_words_reals(bat_words *words, const char *what, size_t count, double **out)
{
    double *values = NULL;
    batten_status status = bat_words_check(words, what, count, 1);
    if (status == BATTEN_OK)
        status = bat_input_array(words->input, count, sizeof *values, &values);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_words_real(words, what, &values[i]);
    if (status == BATTEN_OK)
        *out = values;
    else
        bat_release(values);
    return status;
}
