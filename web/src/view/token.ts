// The token stands in the start address. It is kept for this tab and taken out of the address bar,
// so that it gets neither into a bookmark nor over a shoulder.

const key = "somato-token";

export function takeToken(): string {
  const address = new URL(window.location.href);
  const given = address.searchParams.get("token");
  if (given === null) return stored();
  keep(given);
  address.searchParams.delete("token");
  window.history.replaceState(null, "", address);
  return given;
}

function stored(): string {
  try {
    return window.sessionStorage.getItem(key) ?? "";
  } catch {
    return ""; // storage may be forbidden
  }
}

function keep(token: string): void {
  try {
    window.sessionStorage.setItem(key, token);
  } catch {
    // Then reloading the page asks for the start address again.
  }
}
