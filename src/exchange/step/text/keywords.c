/* Keywords of records, which files write in either case. */
#include "exchange/step/text/instances.h"

#include <string.h>

bool bat_step_same_word(const char *bytes, const char *word, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        const char c = bytes[i];
        if ((c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c) != word[i])
            return false;
    }
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
