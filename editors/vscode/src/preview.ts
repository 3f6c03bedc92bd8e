// A script to its preview beside the text: the page that the language server has, in a panel that follows the text.
import { basename } from "node:path";
import * as vscode from "vscode";
import {
  ExecuteCommandRequest,
  type LanguageClient,
  ShowDocumentRequest,
  type TextDocumentPositionParams,
} from "vscode-languageclient/node";

const panels = new Map<string, Panel>();

interface Panel {
  view: vscode.WebviewPanel;
  address: string;
}

/** Opens the preview of a script, or brings it forward, from so many seconds on; without `uri`, of the one that is edited. */
export async function preview(client: LanguageClient, uri?: vscode.Uri | string, seconds?: number): Promise<void> {
  const asked = typeof uri === "string" ? vscode.Uri.parse(uri, true) : uri;
  const script = asked ?? vscode.window.activeTextEditor?.document.uri;
  if (script === undefined) return;
  const from = typeof seconds === "number" ? seconds : null;
  const address = await client.sendRequest(ExecuteCommandRequest.type, {
    command: "facescript.preview",
    arguments: [client.code2ProtocolConverter.asUri(script), from, false],
  });
  if (address) await show(script, address); // without one, the server has told why
}

/** Closes all previews: their pages are gone. */
export function closePreviews(): void {
  for (const { view } of [...panels.values()]) view.dispose();
}

/** Tells the server where the caret is in a script that is previewed: the page lights what is written there. */
export function follow(client: LanguageClient | undefined, editor: vscode.TextEditor): void {
  const { uri } = editor.document;
  if (!client?.isRunning() || !panels.has(uri.toString())) return;
  const place: TextDocumentPositionParams = {
    textDocument: { uri: client.code2ProtocolConverter.asUri(uri) },
    position: client.code2ProtocolConverter.asPosition(editor.selection.active),
  };
  void client.sendNotification("facescript/caret", place);
}

/** Shows what is clicked in a preview where its script is, not in the preview's own column. */
export const shown: ShowDocumentRequest.MiddlewareSignature = async (params, token, next) => {
  const uri = vscode.Uri.parse(params.uri, true);
  if (params.external || !panels.has(uri.toString())) return next(params, token);
  const beside = vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === uri.toString());
  const viewColumn = beside?.viewColumn ?? vscode.ViewColumn.One;
  const { start, end } = params.selection ?? { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } };
  const selection = new vscode.Range(start.line, start.character, end.line, end.character);
  await vscode.window.showTextDocument(uri, { viewColumn, selection, preserveFocus: !params.takeFocus });
  return { success: true };
};

async function show(script: vscode.Uri, address: string): Promise<void> {
  const name = script.toString();
  const panel = panels.get(name) ?? { view: opened(script), address: "" };
  if (panel.address !== address) {
    panel.view.webview.html = framed(await reached(address), basename(script.fsPath));
    panel.address = address;
    panels.set(name, panel);
  }
  panel.view.reveal(undefined, true);
}

/** The address by which this window reaches a page of the machine where scripts are; not each window that is elsewhere
 * keeps more of it than host and port. */
async function reached(address: string): Promise<string> {
  const { origin, pathname } = new URL(address);
  const host = await vscode.env.asExternalUri(vscode.Uri.parse(`${origin}/`, true));
  return host.toString(true).replace(/\/?$/, pathname);
}

function opened(script: vscode.Uri): vscode.WebviewPanel {
  const where = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
  const view = vscode.window.createWebviewPanel("facescript.preview", `Preview ${basename(script.fsPath)}`, where, {
    enableScripts: true, // a frame may do what the page around it may
    retainContextWhenHidden: true,
    localResourceRoots: [],
  });
  view.onDidDispose(() => panels.delete(script.toString()));
  return view;
}

/** A page that holds the preview and may hold nothing else. */
function framed(page: string, name: string): string {
  const source = new URL(page).origin;
  const [address, title] = [page, name].map((text) => text.replace(/[&"<]/g, (sign) => `&#${sign.charCodeAt(0)};`));
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; frame-src ${source}; style-src 'unsafe-inline'">
<style>html, body, iframe { width: 100%; height: 100%; margin: 0; padding: 0; border: 0; overflow: hidden; }</style>
</head>
<body><iframe src="${address}" title="Preview of ${title}" allow="autoplay"></iframe></body>
</html>`;
}
