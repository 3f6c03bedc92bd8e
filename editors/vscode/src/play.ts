// A script and a moment to a page that plays from there, shown beside the text.
import { execFile } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdir, readFile } from "node:fs/promises";
import { basename, dirname, join } from "node:path";
import * as vscode from "vscode";
import { program } from "./program";

const panels = new Map<string, vscode.WebviewPanel>();

/** Plays a script from so many seconds on; without `uri`, the one that is being edited. */
export async function play(
  context: vscode.ExtensionContext,
  output: vscode.LogOutputChannel,
  uri?: vscode.Uri | string,
  seconds = 0,
): Promise<void> {
  const script = await saved(uri);
  if (script === undefined) return;
  try {
    const page = await pageOf(script, Number(seconds) || 0, context.globalStorageUri.fsPath, output);
    if (page !== undefined) show(script, page);
  } catch (failure) {
    const message = failure instanceof Error ? failure.message : String(failure);
    output.error(message);
    const chosen = await vscode.window.showErrorMessage(`${basename(script)} cannot be played: ${first(message)}`, "Show Output");
    if (chosen) output.show();
  }
}

/** The path of the script, once what was typed is in its file: that is what the program reads. */
async function saved(uri?: vscode.Uri | string): Promise<string | undefined> {
  const asked = typeof uri === "string" ? vscode.Uri.parse(uri, true) : uri;
  const place = asked ?? vscode.window.activeTextEditor?.document.uri;
  if (place === undefined) return undefined;
  const document = await vscode.workspace.openTextDocument(place);
  if (document.uri.scheme !== "file") {
    void vscode.window.showInformationMessage("Save the script first: it is played from its file.");
    return undefined;
  }
  return document.isDirty && !(await document.save()) ? undefined : document.uri.fsPath;
}

/** The page's text; undefined where the author cancels. */
async function pageOf(
  script: string,
  seconds: number,
  storage: string,
  output: vscode.LogOutputChannel,
): Promise<string | undefined> {
  await mkdir(storage, { recursive: true });
  const page = join(storage, `${createHash("sha256").update(script).digest("hex").slice(0, 16)}.html`);
  const from = seconds > 0 ? ["--from", `${seconds}s`] : [];
  const where = { location: vscode.ProgressLocation.Notification, title: `Building ${basename(script)}`, cancellable: true };
  const done = await vscode.window.withProgress(where, (_, token) =>
    run(["build", script, "-o", page, "--quiet", ...from], script, token, output),
  );
  return done ? await readFile(page, "utf8") : undefined;
}

/** Runs the program in the script's project; false where the author cancels. */
function run(
  args: string[],
  script: string,
  token: vscode.CancellationToken,
  output: vscode.LogOutputChannel,
): Promise<boolean> {
  const folder = vscode.workspace.getWorkspaceFolder(vscode.Uri.file(script));
  return new Promise((resolve, reject) => {
    const options = { cwd: folder?.uri.fsPath ?? dirname(script), maxBuffer: 1 << 24 };
    const running = execFile(program(), args, options, (failure, _, said) => {
      if (token.isCancellationRequested) resolve(false);
      else if (failure) reject(new Error(said.trim() || failure.message));
      else {
        if (said.trim()) output.info(said.trim());
        resolve(true);
      }
    });
    token.onCancellationRequested(() => running.kill());
  });
}

function show(script: string, page: string): void {
  let panel = panels.get(script);
  if (panel === undefined) {
    const where = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    panel = vscode.window.createWebviewPanel("facescript.page", basename(script), where, {
      enableScripts: true,
      localResourceRoots: [],
    });
    panel.onDidDispose(() => panels.delete(script));
    panels.set(script, panel);
  }
  panel.webview.html = page;
  panel.reveal(undefined, true);
}

function first(message: string): string {
  return message.split("\n", 1)[0];
}
