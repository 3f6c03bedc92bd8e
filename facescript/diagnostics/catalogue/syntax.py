"""Codes FS1xx, what cannot be read as the language."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

HELLO = 'say "Hello."\n'

SIGNS: tuple[Entry, ...] = (
    Entry(
        "FS101",
        "tab",
        Severity.ERROR,
        "A tab stands here; write spaces.",
        "scene a:\n\tnod\n",
        "scene a:\n    nod\n",
        "Tabs are as wide as each program likes, and blocks are made by indentation. Lines in a row are reported once.",
    ),
    Entry(
        "FS102",
        "curly-quote",
        Severity.ERROR,
        '`{sign}` is no quotation mark here; texts stand between two `"`.',
        "say “Hello.”\n",
        HELLO,
        "Word processors and other scripts have quotation marks of their own. Inside a text all of them are free.",
    ),
    Entry(
        "FS103",
        "look-alike",
        Severity.ERROR,
        "`{sign}` only looks like a sign of the language; write {meant}.",
        "repeat 2 times：nod\n",
        "repeat 2 times: nod\n",
        "Full-width signs, long dashes and unusual spaces are not signs of the language. Inside a text they are free.",
    ),
    Entry(
        "FS104",
        "text-unclosed",
        Severity.ERROR,
        'A text begins here and does not end in this line; write `"` at its end.',
        'say "Hello.\n',
        HELLO,
        "A text ends in the line it begins in; a long one goes on in further texts on the lines below, indented.",
    ),
    Entry(
        "FS105",
        "unknown-sign",
        Severity.ERROR,
        "`{sign}` has no meaning here; remove it, or write it inside a text.",
        "nod!\n",
        "nod\n",
    ),
    Entry(
        "FS106",
        "hidden-character",
        Severity.ERROR,
        "The character {sign} stands here and is not drawn; remove it.",
        "nod\u202e 20%\n",
        "nod 20%\n",
        "Characters that steer the direction of text or have no shape make a script look like another one. "
        "In a text, those that steer its direction are free.",
    ),
    Entry(
        "FS109",
        "comment-space",
        Severity.ERROR,
        "A comment is `#` and a space; write `# ` here.",
        "nod #twice\n",
        "nod # twice\n",
        "`#` without a space begins a colour.",
    ),
    Entry(
        "FS110",
        "colour-form",
        Severity.ERROR,
        "`{colour}` is no colour; a colour is `#` and six or eight hex digits.",
        "background #12\nnod\n",
        "background #121212\nnod\n",
        "Red, green, blue and, if wanted, opacity, two digits each.",
    ),
)

NUMBERS: tuple[Entry, ...] = (
    Entry(
        "FS111",
        "minus-spaces",
        Severity.ERROR,
        "Write a space on both sides of `-` between two values.",
        "let beat = 400ms\nwait beat- 100ms\n",
        "let beat = 400ms\nwait beat - 100ms\n",
        "`-` inside a name belongs to the name, before digits to the number; between spaces it subtracts.",
    ),
    Entry(
        "FS112",
        "space-missing",
        Severity.ERROR,
        "Write a space between `{first}` and `{second}`.",
        'say "Hello."as greeting\nwait until greeting.end\n',
        'say "Hello." as greeting\nwait until greeting.end\n',
    ),
    Entry(
        "FS113",
        "unit-apart",
        Severity.ERROR,
        "Write the unit `{unit}` touching its number.",
        "wait 2 s\n",
        "wait 2s\n",
    ),
    Entry(
        "FS114",
        "number-form",
        Severity.ERROR,
        "`{written}` is no number; write digits, with a point if needed, and the unit touching them, as in `1.5s`.",
        "wait 1,5s\n",
        "wait 1.5s\n",
    ),
    Entry(
        "FS115",
        "number-long",
        Severity.ERROR,
        "This number is longer than {longest} characters; write it shorter.",
        "wait 0.123456789012345678s\n",
        "wait 0.123s\n",
        "So many digits are not kept; a slip of the keyboard is likelier.",
    ),
)

SIZES: tuple[Entry, ...] = (
    Entry(
        "FS116",
        "line-long",
        Severity.ERROR,
        "This line is longer than {longest} characters; break it after a comma, or go on in texts on lines below.",
        "nod\n# " + "=" * 10_000 + "\n",
        "nod\n# " + "=" * 100 + "\n",
        "A line goes on in the next after a comma, `+` or `=`; a text goes on in further texts below it, indented.",
    ),
    Entry(
        "FS117",
        "script-long",
        Severity.ERROR,
        "This script is longer than {largest} characters; move definitions to a file of their own and `use` it.",
        HELLO,
        HELLO,
        stage="unforced",
    ),
    Entry(
        "FS118",
        "nested-deep",
        Severity.ERROR,
        "More than {deepest} blocks or brackets stand in each other here; name some of it as an action or expression.",
        "in turn: " * 40 + "nod\n",
        "in turn: " * 4 + "nod\n",
    ),
    Entry(
        "FS119",
        "faults-many",
        Severity.HINT,
        "More is wrong than the {most} places told; mend these first.",
        HELLO,
        HELLO,
        stage="unforced",
    ),
)

BLOCKS: tuple[Entry, ...] = (
    Entry(
        "FS107",
        "indentation-between",
        Severity.ERROR,
        "This line is indented by {indent}, the blocks around it by {outer} and {inner}; indent it as one of them.",
        "scene a:\n    together:\n        nod\n      blink\n",
        "scene a:\n    together:\n        nod\n        blink\n",
        "Lines of one block begin in the same column.",
    ),
    Entry(
        "FS108",
        "indentation-unexpected",
        Severity.ERROR,
        "This line is indented, and no line above opens a block for it; indent it like the line above.",
        "nod 20%\n    blink\n",
        "nod 20%\nblink\n",
        "A block stands after a colon; texts and `on` below a `say`, settings below a `face`, times below a `target`.",
    ),
    Entry(
        "FS120",
        "colon-missing",
        Severity.ERROR,
        "Write `:` after `{header}`; a statement or a block follows it.",
        "scene a\n    nod\n",
        "scene a:\n    nod\n",
    ),
    Entry(
        "FS121",
        "colon-unexpected",
        Severity.ERROR,
        "No `:` can stand after `{before}`; it stands after a face's name, and in lines that begin with "
        "`scene when action repeat at on together choose in turn`.",
        "look at camera:\nnod\n",
        "look at camera\nnod\n",
    ),
    Entry(
        "FS122",
        "block-empty",
        Severity.ERROR,
        "Nothing stands after the `:` of `{header}`; write a statement behind it or indented below it.",
        "nod\ntogether:\n",
        "nod\ntogether:\n    nod\n    blink\n",
    ),
    Entry(
        "FS123",
        "script-empty",
        Severity.ERROR,
        'There is nothing in this script; write for example `say "Hello."`.',
        "# to do\n",
        HELLO,
    ),
    Entry(
        "FS132",
        "definition-inside",
        Severity.ERROR,
        "`{word}` stands outside of all blocks; write it at the start of a line, without indentation.",
        "scene a:\n    nod\n    let beat = 2s\n",
        "scene a:\n    nod\n",
    ),
    Entry(
        "FS133",
        "on-outside",
        Severity.ERROR,
        "`on` stands indented below the `say` whose word it waits for; indent it there.",
        'say "Hello."\non "Hello": nod\n',
        'say "Hello."\n    on "Hello": nod\n',
    ),
    Entry(
        "FS134",
        "under-line",
        Severity.ERROR,
        'Below a line stand only the texts that it goes on with and `on "word":`; move this out of it.',
        'say "Hello."\n    on "Hello": nod\n    blink\n',
        'say "Hello."\n    on "Hello": nod\nblink\n',
    ),
)

WORDS: tuple[Entry, ...] = (
    Entry(
        "FS124",
        "equals-missing",
        Severity.ERROR,
        "A value follows `{before}`; write ` = ` before it.",
        "let beat 2s\nwait beat\n",
        "let beat = 2s\nwait beat\n",
    ),
    Entry(
        "FS125",
        "value-missing",
        Severity.ERROR,
        "A word or a value is missing {where}.",
        "show smile + + AU6\n",
        "show smile + AU6\n",
    ),
    Entry(
        "FS126",
        "line-unfinished",
        Severity.ERROR,
        "A line that ends in `{sign}` goes on in the next, and there is nothing that goes on.",
        "look at camera,\n\nnod\n",
        "look at camera,\n    eyes only\nnod\n",
    ),
    Entry(
        "FS127",
        "line-joined",
        Severity.ERROR,
        "This comma at the end of the line joins the line below to it; remove it.",
        "face ada = woman,\nada: nod\n",
        "face ada = woman\nada: nod\n",
        "A line goes on in the next after a comma, `+` or `=`.",
    ),
    Entry(
        "FS128",
        "bracket-unclosed",
        Severity.ERROR,
        "This bracket is not closed; write `)`.",
        "show smile (20% + 30%\n",
        "show smile (20% + 30%)\n",
    ),
    Entry(
        "FS129",
        "bracket-unopened",
        Severity.ERROR,
        "This bracket closes none; remove it.",
        "show smile 20%)\n",
        "show smile 20%\n",
    ),
    Entry(
        "FS130",
        "quotes-missing",
        Severity.ERROR,
        "A text stands here; write `{text}`.",
        'say "Hello."\n    on Hello: nod\n',
        'say "Hello."\n    on "Hello": nod\n',
    ),
    Entry(
        "FS131",
        "name-missing",
        Severity.ERROR,
        "A name stands after `{before}`: a letter, then letters, digits, `_` and inner `-`, without quotes.",
        'scene "a":\n    nod\n',
        "scene a:\n    nod\n",
    ),
    Entry(
        "FS135",
        "word-unexpected",
        Severity.ERROR,
        "`{word}` cannot stand here.",
        "show smile = 20%\n",
        "show smile 20%\n",
    ),
)

COMMAS: tuple[Entry, ...] = (
    Entry(
        "FS140",
        "comma-extra",
        Severity.HINT,
        "`{word}` follows without a comma.",
        "show smile, over 2s\n",
        "show smile over 2s\n",
        "`over for back ease from timed to as` follow directly, all other modifiers after a comma. `fmt` sets both.",
    ),
    Entry(
        "FS141",
        "comma-missing",
        Severity.HINT,
        "A comma stands before `{word}`.",
        "look at camera eyes only\n",
        "look at camera, eyes only\n",
        "`over for back ease from timed to as` follow directly, all other modifiers after a comma. `fmt` sets both.",
    ),
    Entry(
        "FS142",
        "as-last",
        Severity.HINT,
        "`as {name}` stands last in its statement.",
        "look at camera as first, eyes only\nwait until first.end\n",
        "look at camera, eyes only as first\nwait until first.end\n",
        "The name of a statement stands where the eye finds it: at its end. `fmt` puts it there.",
    ),
)

SYNTAX: tuple[Entry, ...] = tuple(
    sorted((*SIGNS, *NUMBERS, *SIZES, *BLOCKS, *WORDS, *COMMAS), key=lambda entry: entry.code)
)
