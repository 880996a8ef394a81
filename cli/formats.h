/* The table of formats, for the help, and formats by the word that names them. */
#ifndef CLI_FORMATS_H
#define CLI_FORMATS_H
#include "command.h"

/* The option of all commands that read a file. */
#define FROM_FORMAT_OPTION                                                           \
    {                                                                                \
        "from-format", 0, OPTION_VALUE, "FORMAT",                                    \
            "what IN is, where its content does not tell; see 'batten help formats'" \
    }

/* What `batten help formats` says. */
void formats_manual(batten_text *text);
/* The format that an option names; AUTO when it was not given. False with a complaint for a
 * word that names none. */
bool formats_option(const char *of, const arguments *given, const char *name,
                    batten_format *format);

#endif
