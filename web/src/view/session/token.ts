// The token is part of the start address. It is stored for this tab and removed from the address
// bar, so that it is neither bookmarked nor visible.

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
    return ""; // storage may be disabled
  }
}

function keep(token: string): void {
  try {
    window.sessionStorage.setItem(key, token);
  } catch {
    // Reloading the page then requires the start address.
  }
}
