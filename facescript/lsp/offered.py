"""What the server offers an editor, and in which file of `features/` each of it is.

The table stands by itself so that an editor is answered before the compiler is loaded.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from lsprotocol import types

Type, Modifier = types.SemanticTokenTypes, types.SemanticTokenModifiers

TOKEN_TYPES = (
    Type.Keyword,
    Type.Class,
    Type.Variable,
    Type.EnumMember,
    Type.Function,
    Type.Event,
    Type.Namespace,
    Type.Parameter,
    Type.Variable,
    Type.Type,
    Type.Property,
    Type.String,
    Type.Number,
    Type.Number,
    Type.Comment,
    Type.Operator,
)
"""The protocol's word for each `Meaning`: the nearest that editors have colours for."""

TOKEN_MODIFIERS = (Modifier.Definition, Modifier.Readonly, Modifier.DefaultLibrary)
"""What the bits of a token mean, the lowest first."""

TOKENS = types.SemanticTokensLegend([kind.value for kind in TOKEN_TYPES], [kind.value for kind in TOKEN_MODIFIERS])


CARET = "facescript/caret"
"""An editor's word of where the caret is: `TextDocumentPositionParams`."""

PREVIEW = "facescript.preview"
"""The command that shows a document: its address; a time to play from, or null; false where the editor shows the page
itself. Answers the page's address, null where there is none."""


class Offer(NamedTuple):
    """A method of the protocol, the file that answers it, and what the editor is told of it."""

    method: str
    feature: str
    options: Any = None


OFFERED = (
    Offer(types.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY, "calls"),
    Offer(types.CALL_HIERARCHY_INCOMING_CALLS, "calls"),
    Offer(types.CALL_HIERARCHY_OUTGOING_CALLS, "calls"),
    Offer(types.TEXT_DOCUMENT_DOCUMENT_COLOR, "colours"),
    Offer(types.TEXT_DOCUMENT_COLOR_PRESENTATION, "colours"),
    Offer(
        types.TEXT_DOCUMENT_COMPLETION,
        "completion",
        types.CompletionOptions(trigger_characters=[" ", ".", '"', "[", "(", "/"], resolve_provider=True),
    ),
    Offer(types.COMPLETION_ITEM_RESOLVE, "completion"),
    Offer(types.TEXT_DOCUMENT_DEFINITION, "definition"),
    Offer(types.TEXT_DOCUMENT_DID_OPEN, "diagnostics"),
    Offer(types.TEXT_DOCUMENT_DID_CHANGE, "diagnostics"),
    Offer(types.TEXT_DOCUMENT_DID_CLOSE, "diagnostics"),
    Offer(
        types.TEXT_DOCUMENT_DIAGNOSTIC,
        "diagnostics",
        types.DiagnosticOptions(inter_file_dependencies=True, workspace_diagnostics=False, identifier="facescript"),
    ),
    Offer(
        types.TEXT_DOCUMENT_CODE_ACTION,
        "fixes",
        types.CodeActionOptions(code_action_kinds=[types.CodeActionKind.QuickFix, types.CodeActionKind.SourceFixAll]),
    ),
    Offer(types.TEXT_DOCUMENT_FOLDING_RANGE, "folding"),
    Offer(types.TEXT_DOCUMENT_FORMATTING, "formatting"),
    Offer(types.TEXT_DOCUMENT_RANGE_FORMATTING, "formatting"),
    Offer(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT, "highlight"),
    Offer(types.TEXT_DOCUMENT_HOVER, "hover"),
    Offer(types.TEXT_DOCUMENT_INLAY_HINT, "inlay_hints"),
    Offer(types.TEXT_DOCUMENT_CODE_LENS, "lenses"),
    Offer(types.TEXT_DOCUMENT_DOCUMENT_LINK, "links"),
    Offer(CARET, "preview"),
    Offer(types.SHUTDOWN, "preview"),
    Offer(types.TEXT_DOCUMENT_REFERENCES, "references"),
    Offer(types.TEXT_DOCUMENT_PREPARE_RENAME, "rename"),
    Offer(types.TEXT_DOCUMENT_RENAME, "rename", types.RenameOptions(prepare_provider=True)),
    Offer(types.TEXT_DOCUMENT_SELECTION_RANGE, "selection"),
    Offer(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, "semantic_tokens", TOKENS),
    Offer(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL_DELTA, "semantic_tokens", TOKENS),
    Offer(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE, "semantic_tokens", TOKENS),
    Offer(
        types.TEXT_DOCUMENT_SIGNATURE_HELP,
        "signature",
        types.SignatureHelpOptions(trigger_characters=["(", ",", " "]),
    ),
    Offer(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL, "symbols"),
    Offer(types.WORKSPACE_SYMBOL, "workspace_symbols"),
)

COMMANDS = (Offer(PREVIEW, "preview"),)
"""What an editor may have done (`workspace/executeCommand`), by names in the place of methods."""
