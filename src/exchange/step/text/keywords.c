/* Keywords of records, which files write in either case. */
#include "exchange/step/text/instances.h"

#include <string.h>

static char upper(char c)
{
    return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c;
}

bool bat_step_same_word(const char *bytes, const char *word, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (upper(bytes[i]) != word[i])
            return false;
    return true;
}

bool bat_step_is_keyword(const bat_step_record *record, const char *word)
{
    const size_t length = strlen(word);
    return record->keyword_length == length &&
           bat_step_same_word(record->keyword, word, length);
}

bool bat_step_keyword_ends(const bat_step_record *record, const char *word)
{
    const size_t length = strlen(word);
    return record->keyword_length >= length &&
           bat_step_same_word(record->keyword + record->keyword_length - length, word, length);
}

const char *bat_step_upper_keyword(const bat_step_record *record,
                                   char buffer[BAT_STEP_KEYWORD_SIZE])
{
    const size_t room = BAT_STEP_KEYWORD_SIZE - 1;
    const size_t length = record->keyword_length < room ? record->keyword_length : room;
    for (size_t i = 0; i < length; i++)
        buffer[i] = upper(record->keyword[i]);
    buffer[length] = '\0';
    return buffer;
}
