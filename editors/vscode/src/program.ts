// The setting `facescript.path` to the program that is run.
import { isAbsolute, resolve } from "node:path";
import * as vscode from "vscode";

export function program(): string {
  const path = vscode.workspace.getConfiguration("facescript").get<string>("path")?.trim() || "facescript";
  const folder = vscode.workspace.workspaceFolders?.[0];
  const relative = /[\\/]/.test(path) && !isAbsolute(path);
  return relative && folder ? resolve(folder.uri.fsPath, path) : path;
}
