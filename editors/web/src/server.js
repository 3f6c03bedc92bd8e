// A language server's help in the editor: completion, hover, signatures, names, form, what is wrong with its mends, and
// the times of what is played.
import { autocompletion } from "@codemirror/autocomplete";
import {
  LSPClient, LSPPlugin, findReferencesKeymap, formatKeymap, hoverTooltips, jumpToDefinitionKeymap, renameKeymap,
  serverCompletion, serverCompletionSource, signatureHelp,
} from "@codemirror/lsp-client";
import { keymap } from "@codemirror/view";
import { keepConnected } from "./connection.js";
import { plainHTML } from "./markdown.js";
import { asker, told } from "./told.js";

const PATIENCE = 30000;  // milliseconds until an answer is given up

// What an offer is said to be comes when it is looked at: the server makes it then.
async function completions(context) {
  const found = await serverCompletionSource(context);
  const plugin = context.view && LSPPlugin.get(context.view);
  if (!found || !plugin) return null;
  const options = found.options.map((option) => ({ ...option, info: () => described(plugin, option.displayLabel) }));
  return { ...found, options };
}

async function described(plugin, label) {
  const { documentation } = await plugin.client.request("completionItem/resolve", { label });
  if (!documentation) return null;
  const place = document.createElement("div");
  place.className = "cm-lsp-documentation cm-lsp-completion-documentation";
  place.innerHTML = plugin.docToHTML(documentation);
  return place;
}

// Helps an editor with a file: its extension, and what ends the talk. `said(state, why)` hears "there", "coming" or
// "gone".
export function help({ view, address, uri, root, said }) {
  const client = new LSPClient({
    rootUri: root,
    timeout: PATIENCE,
    sanitizeHTML: plainHTML,
    extensions: [
      serverCompletion({ validFor: /^[\p{L}\p{N}_-]*$/u }),
      autocompletion({ override: [completions], icons: false }),
      hoverTooltips(),
      signatureHelp(),
      keymap.of([...formatKeymap, ...renameKeymap, ...jumpToDefinitionKeymap, ...findReferencesKeymap]),
      told,
    ],
  });
  const end = keepConnected(
    address,
    (transport) => {
      client.connect(transport).initializing.then(() => { view.plugin(asker)?.later(0), said("there"); }, transport.close);
    },
    (again, why) => { client.disconnect(), said(again ? "coming" : "gone", why); },
  );
  return { extension: client.plugin(uri, "face"), end };
}
