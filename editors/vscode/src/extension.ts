// What VS Code runs for `.face` files: it starts the language server, and plays scripts beside their text.
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";
import { play } from "./play";
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
    vscode.commands.registerCommand("facescript.play", (uri?: vscode.Uri | string, seconds?: number) =>
      play(context, output, uri, seconds),
    ),
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
    { documentSelector: [{ language: "face" }], outputChannel: output },
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
  if (old?.needsStop()) await old.stop().catch((failure) => output.error(String(failure)));
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
