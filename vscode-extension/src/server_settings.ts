// What of the settings the server is told: it warns of those that it does not know.

const sections = ['features', 'hover', 'inlayHint', 'codeLens', 'diagnostics', 'log'] as const;

export function serverSettings(all: unknown): Record<string, unknown> {
  if (typeof all !== 'object' || all === null) return {};
  const given = all as Record<string, unknown>;
  return Object.fromEntries(sections.filter((name) => name in given).map((name) => [name, given[name]]));
}
