// What VS Code runs for `.face` files: it starts the language server, and shows scripts beside their text.
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";
import { closePreviews, follow, preview, shown } from "./preview";
import { program } from "./program";

const SETTING = "facescript.path";
const ABSENT =
  'It comes with Python: pip install "facescript[lsp]". Where it is not on the PATH, say in the settings where it is.';

let client: Client | undefined;
let output: vscode.LogOutputChannel;

/** A client that writes its errors to the output; what an author must know is told once, by `start`. */
class Client extends LanguageClient {
  override error(message: string, data?: unknown): void {
    super.error(message, data, false);
  }
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  output = vscode.window.createOutputChannel("FaceScript", { log: true });
  context.subscriptions.push(
    output,
    vscode.commands.registerCommand("facescript.restart", restart),
    vscode.commands.registerCommand("facescript.play", open),
    vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => follow(client, textEditor)),
    vscode.workspace.onDidChangeConfiguration((change) => change.affectsConfiguration(SETTING) && restart()),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await stop();
}

async function start(): Promise<void> {
  const command = program();
  client = new Client(
    "facescript",
    "FaceScript",
    { command, args: ["lsp"] },
    {
      documentSelector: [{ language: "face" }],
      outputChannel: output,
      middleware: { window: { showDocument: shown } },
    },
  );
  try {
    await client.start();
  } catch (failure) {
    output.error(String(failure));
    void tell(`FaceScript's language server did not start: \`${command} lsp\` cannot be run. ${ABSENT}`);
  }
}

/** Ends the server; one that never started has nothing to end. */
async function stop(): Promise<void> {
  const old = client;
  client = undefined;
  closePreviews();
  if (old?.needsStop()) await old.stop().catch((failure) => output.error(String(failure)));
}

/** Opens a preview: of the script that is edited, or where a lens is clicked. */
async function open(uri?: vscode.Uri | string, seconds?: number): Promise<void> {
  if (!client?.isRunning()) return tell("The preview needs FaceScript's language server, which is not running.");
  try {
    await preview(client, uri, seconds);
  } catch (failure) {
    output.error(String(failure));
    void tell(`The preview cannot be opened: ${failure instanceof Error ? failure.message : String(failure)}`);
  }
}

async function restart(): Promise<void> {
  await stop();
  await start();
}

async function tell(message: string): Promise<void> {
  const chosen = await vscode.window.showErrorMessage(message, "Open Settings", "Show Output");
  if (chosen === "Open Settings") await vscode.commands.executeCommand("workbench.action.openSettings", SETTING);
  if (chosen === "Show Output") output.show();
}
